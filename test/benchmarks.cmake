# Programs that print a table; they need nothing else.
foreach(name long_run many step_cost)
  add_executable(benchmark_${name} test/benchmark/${name}.cpp)
  target_include_directories(benchmark_${name} PRIVATE src test)
  target_link_libraries(benchmark_${name} PRIVATE rigid_body_sim_core rigid_body_compile_options)
endforeach()
# the map of the extremes: scripts/extremes
add_executable(extremes test/extremes/extremes.cpp)
target_link_libraries(extremes PRIVATE rigid_body_extremes rigid_body_compile_options)
include(test/benchmark/peers.cmake)
find_package(benchmark)
# counted, not timed: scripts/count_instructions
add_executable(instructions test/benchmark/instructions.cpp)
target_include_directories(instructions PRIVATE test)
target_link_libraries(instructions PRIVATE rigid_body_sim_core rigid_body_compile_options)
if(benchmark_FOUND)
  foreach(name mesh_mass rotor taylor)
    add_executable(benchmark_${name} test/benchmark/${name}.cpp)
    target_include_directories(benchmark_${name} PRIVATE test)
    target_link_libraries(benchmark_${name} PRIVATE
      rigid_body_sim_scene rigid_body_compile_options benchmark::benchmark)
  endforeach()
endif()
