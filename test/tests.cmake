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

rigid_body_gtest(test_scene
  SOURCES
    test/scene/test_any_text.cpp
    test/scene/test_build_world.cpp
    test/scene/test_file_errors.cpp
    test/scene/test_frames.cpp
    test/scene/test_key_errors.cpp
    test/scene/test_numbers.cpp
    test/scene/test_shipped_scenes.cpp
    test/scene/test_value_errors.cpp
  LIBRARIES rigid_body_sim_scene)
target_compile_definitions(test_scene PRIVATE
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")
