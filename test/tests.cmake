# gtest of the layers without ROS, one program a layer. catkin's gtest targets take the plain
# signature of target_link_libraries.
function(rigid_body_gtest name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  catkin_add_gtest(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE test)
  target_link_libraries(${name} ${ARG_LIBRARIES} rigid_body_compile_options gtest_main)
endfunction()

rigid_body_gtest(test_math
  SOURCES
    test/math/test_compensated_sum.cpp
    test/math/test_hat.cpp
  LIBRARIES rigid_body_sim_core)

rigid_body_gtest(test_mass
  SOURCES
    test/mass/test_checked_mesh.cpp
    test/mass/test_combined.cpp
    test/mass/test_mass_properties_fault.cpp
    test/mass/test_particles.cpp
    test/mass/test_principal_axes.cpp
    test/mass/test_shapes.cpp
    test/mass/test_triangle_mesh.cpp
  LIBRARIES rigid_body_sim_core)

rigid_body_gtest(test_dynamics
  SOURCES
    test/dynamics/test_methods.cpp
    test/dynamics/test_simulation.cpp
    test/dynamics/test_wrench.cpp
    test/dynamics/test_wrench_schedule.cpp
  LIBRARIES rigid_body_sim_core)

rigid_body_gtest(test_scene
  SOURCES
    test/scene/test_any_text.cpp
    test/scene/test_build_world.cpp
    test/scene/test_file_errors.cpp
    test/scene/test_frames.cpp
    test/scene/test_key_errors.cpp
    test/scene/test_numbers.cpp
    test/scene/test_read_mesh.cpp
    test/scene/test_shipped_scenes.cpp
    test/scene/test_value_errors.cpp
  LIBRARIES rigid_body_sim_scene)
target_compile_definitions(test_scene PRIVATE
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")
rigid_body_gtest(test_taylor
  SOURCES
    test/dynamics/test_taylor_segment.cpp
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
