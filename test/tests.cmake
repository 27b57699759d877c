# gtest of the layers without ROS, one program a layer. catkin's gtest targets take the plain
# signature of target_link_libraries.
function(rigid_body_gtest name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  catkin_add_gtest(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE test)
  target_link_libraries(${name} ${ARG_LIBRARIES} rigid_body_compile_options gtest_main)
endfunction()

rigid_body_gtest(test_mass
  SOURCES
    test/mass/test_principal_axes.cpp
  LIBRARIES rigid_body_sim_core)

rigid_body_gtest(test_rotor
  SOURCES
    test/dynamics/test_rotor.cpp
  LIBRARIES rigid_body_sim_core)
