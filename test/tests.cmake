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
    test/dynamics/test_rotor_laws.cpp
  LIBRARIES rigid_body_sim_core)

# Boost and GSL are other people's elliptic functions to compare with; nothing else needs them.
find_package(GSL REQUIRED)
rigid_body_gtest(test_elliptic
  SOURCES
    test/math/test_elliptic.cpp
  LIBRARIES rigid_body_sim_core GSL::gsl)
