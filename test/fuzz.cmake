# libFuzzer's programs; the libraries must be built with RIGID_BODY_SIM_SANITIZE of scripts/fuzz.
function(rigid_body_sim_fuzzer name)
  set(target rigid_body_sim_fuzz_${name})
  add_executable(${target} test/fuzz/fuzz_${name}.cpp)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME fuzz_${name})
  target_include_directories(${target} PRIVATE test)
  target_link_libraries(${target} PRIVATE ${ARGN} rigid_body_sim_options -fsanitize=fuzzer)
endfunction()

rigid_body_sim_fuzzer(command rigid_body_sim_ros)
rigid_body_sim_fuzzer(mesh rigid_body_sim_scene)
rigid_body_sim_fuzzer(scene rigid_body_sim_scene)
rigid_body_sim_fuzzer(wrench rigid_body_sim_ros ${CONSOLE_BRIDGE_LIBRARY})
