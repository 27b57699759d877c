# What several programs of tests and benchmarks share, compiled once for them all.
file(GLOB sources CONFIGURE_DEPENDS test/support/*.cpp)
add_library(rigid_body_sim_test_support STATIC EXCLUDE_FROM_ALL ${sources})
target_include_directories(rigid_body_sim_test_support PUBLIC test)
target_link_libraries(rigid_body_sim_test_support
  PUBLIC rigid_body_sim_core PRIVATE rigid_body_sim_options)
target_compile_options(rigid_body_sim_test_support PRIVATE $<$<CONFIG:Release>:-O1>)

# The sections of the map of the extremes, for its program and its tests.
add_library(rigid_body_sim_extreme_cases STATIC EXCLUDE_FROM_ALL
  test/extremes/cell.cpp
  test/extremes/cell_lines.cpp
  test/extremes/contacts.cpp
  test/extremes/free_bodies.cpp
  test/extremes/loads.cpp
  test/extremes/one_body.cpp
  test/extremes/refusals.cpp
  test/extremes/schedules.cpp)
target_include_directories(rigid_body_sim_extreme_cases PUBLIC test)
target_link_libraries(rigid_body_sim_extreme_cases
  PUBLIC rigid_body_sim_scene rigid_body_sim_test_support PRIVATE rigid_body_sim_options)
target_compile_options(rigid_body_sim_extreme_cases PRIVATE $<$<CONFIG:Release>:-O1>)
