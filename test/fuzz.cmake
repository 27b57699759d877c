# libFuzzer's programs; the libraries must be built with RIGID_BODY_SIM_SANITIZE of scripts/fuzz.
function(rigid_body_fuzzer name)
  add_executable(fuzz_${name} test/fuzz/fuzz_${name}.cpp)
  target_include_directories(fuzz_${name} PRIVATE src test)
  target_link_libraries(fuzz_${name} PRIVATE ${ARGN} rigid_body_compile_options -fsanitize=fuzzer)
endfunction()

rigid_body_fuzzer(mesh rigid_body_sim_scene)
rigid_body_fuzzer(scene rigid_body_sim_scene)
rigid_body_fuzzer(wrench rigid_body_sim_ros ${CONSOLE_BRIDGE_LIBRARY})
