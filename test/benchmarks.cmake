# A program with a name of its own, as benchmarks and the map of the extremes are.
function(rigid_body_sim_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  set(target rigid_body_sim_${name})
  add_executable(${target} ${ARG_SOURCES})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_include_directories(${target} PRIVATE test)
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} rigid_body_sim_options)
endfunction()

# Programs that print a table; they need nothing else.
foreach(name long_run many motors roofline step_cost touch_cost)
  rigid_body_sim_benchmark(benchmark_${name}
    SOURCES test/benchmark/${name}.cpp LIBRARIES rigid_body_sim_test_support)
endforeach()
# the map of the extremes: scripts/extremes
rigid_body_sim_benchmark(extremes
  SOURCES test/extremes/extremes.cpp LIBRARIES rigid_body_sim_extreme_cases)
# counted, not timed: scripts/count_instructions
rigid_body_sim_benchmark(instructions
  SOURCES test/benchmark/instructions.cpp LIBRARIES rigid_body_sim_test_support)
include(test/benchmark/peers.cmake)
find_package(benchmark)
if(benchmark_FOUND)
  foreach(name mesh_mass free_top taylor)
    rigid_body_sim_benchmark(benchmark_${name}
      SOURCES test/benchmark/${name}.cpp
      LIBRARIES rigid_body_sim_scene rigid_body_sim_test_support benchmark::benchmark)
  endforeach()
endif()
