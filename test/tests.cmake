# All gtests that need no ROS master. Their names are listed in gtests.txt of the build directory.
add_custom_target(rigid_body_gtests)
file(WRITE ${CMAKE_BINARY_DIR}/gtests.txt "")

# One program a layer. catkin's gtest targets take the plain signature of target_link_libraries.
function(rigid_body_gtest name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  catkin_add_gtest(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE test)
  target_link_libraries(${name} ${ARG_LIBRARIES} rigid_body_compile_options gtest_main)
  # helpers of the same name in several files are no fault
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  add_dependencies(rigid_body_gtests ${name})
  file(APPEND ${CMAKE_BINARY_DIR}/gtests.txt "${name}\n")
endfunction()

rigid_body_gtest(test_math
  SOURCES
    test/math/test_compensated_sum.cpp
    test/math/test_gauss_legendre.cpp
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
    test/dynamics/test_describe_solution.cpp
    test/dynamics/test_law_motion.cpp
    test/dynamics/test_laws.cpp
    test/dynamics/test_auto.cpp
    test/dynamics/test_balance.cpp
    test/dynamics/test_foreseen_motion.cpp
    test/dynamics/test_methods.cpp
    test/dynamics/test_stiff_laws.cpp
    test/dynamics/test_simulation.cpp
    test/dynamics/test_simulation_wrenches.cpp
    test/dynamics/test_wrench.cpp
    test/dynamics/test_wrench_schedule.cpp
  LIBRARIES rigid_body_sim_core)

rigid_body_gtest(test_scene
  SOURCES
    test/scene/test_any_text.cpp
    test/scene/test_build_world.cpp
    test/scene/test_file_errors.cpp
    test/scene/test_forces.cpp
    test/scene/test_frames.cpp
    test/scene/test_law_scenes.cpp
    test/scene/test_limits.cpp
    test/scene/test_key_errors.cpp
    test/scene/test_mesh_limits.cpp
    test/scene/test_mesh_of_scene.cpp
    test/scene/test_numbers.cpp
    test/scene/test_parts_and_particles.cpp
    test/scene/test_read_mesh.cpp
    test/scene/test_shipped_scenes.cpp
    test/scene/test_urdf.cpp
    test/scene/test_value_errors.cpp
    test/scene/test_visuals_of.cpp
  LIBRARIES rigid_body_sim_scene)
target_compile_definitions(test_scene PRIVATE
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")

rigid_body_gtest(test_node
  SOURCES
    test/ros/test_arrow_markers.cpp
    test/ros/test_conversions.cpp
    test/ros/test_input_replay.cpp
    test/ros/test_handles.cpp
    test/ros/test_markers.cpp
    test/ros/test_mouse_holds.cpp
    test/ros/test_mouse_spring.cpp
    test/ros/test_node_options.cpp
    test/ros/test_outputs.cpp
    test/ros/test_pacing.cpp
    test/ros/test_refusals.cpp
    test/ros/test_state_requests.cpp
    test/ros/test_static_frames.cpp
    test/ros/test_status.cpp
    test/ros/test_wrench_intake.cpp
    test/ros/test_wrench_matrix.cpp
    test/ros/test_wrench_messages.cpp
  LIBRARIES rigid_body_sim_ros)

rigid_body_gtest(test_tools
  SOURCES
    test/tools/test_help.cpp
    test/tools/test_mass_properties_program.cpp
    test/tools/test_simulate_bags.cpp
    test/tools/test_simulate_program.cpp
  LIBRARIES rigid_body_sim_bag)
target_compile_definitions(test_tools PRIVATE
  RIGID_BODY_SIM_CONFIG="${PROJECT_SOURCE_DIR}/config"
  RIGID_BODY_SIM_DEMO_PUSHER="$<TARGET_FILE:demo_pusher>"
  RIGID_BODY_SIM_MASS_PROPERTIES="$<TARGET_FILE:mass_properties>"
  RIGID_BODY_SIM_NODE="$<TARGET_FILE:rigid_body_node>"
  RIGID_BODY_SIM_SIMULATE="$<TARGET_FILE:simulate>"
  RIGID_BODY_SIM_TRADE="$<TARGET_FILE:trade>"
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")
add_dependencies(test_tools demo_pusher mass_properties rigid_body_node simulate trade)

rigid_body_gtest(test_trade
  SOURCES
    test/tools/test_trade_measures.cpp
    test/tools/test_trade_program.cpp
    test/tools/test_trade_scenes.cpp
  LIBRARIES rigid_body_trade rigid_body_sim_scene)
target_compile_definitions(test_trade PRIVATE
  RIGID_BODY_SIM_TRADE="$<TARGET_FILE:trade>"
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")
add_dependencies(test_trade trade)

# rostests: the node in a process of its own, driven through its topics and services.
find_package(rostest REQUIRED)
find_package(roslaunch REQUIRED)
# what drives the node in them
add_library(rigid_body_node_driver STATIC EXCLUDE_FROM_ALL
  test/ros/node_driver.cpp test/ros/reference_run.cpp)
target_include_directories(rigid_body_node_driver PUBLIC test)
target_link_libraries(rigid_body_node_driver
  PUBLIC rigid_body_sim_ros gtest PRIVATE rigid_body_compile_options)
function(rigid_body_rostest name)
  add_rostest_gtest(test_${name} test/ros/${name}.test test/ros/test_${name}.cpp)
  target_link_libraries(test_${name} rigid_body_node_driver rigid_body_compile_options)
  add_dependencies(test_${name} rigid_body_node)
  target_compile_definitions(test_${name} PRIVATE
    RIGID_BODY_SIM_NODE="$<TARGET_FILE:rigid_body_node>"
    RIGID_BODY_SIM_SIMULATE="$<TARGET_FILE:simulate>"
    RIGID_BODY_SIM_FOLLOWER_SCENE="${PROJECT_SOURCE_DIR}/test/ros/follower.yaml"
    RIGID_BODY_SIM_TEST_SCENE="${PROJECT_SOURCE_DIR}/test/ros/lopsided.yaml")
endfunction()
rigid_body_rostest(clock)
rigid_body_rostest(doors)
rigid_body_rostest(fleet)
rigid_body_rostest(launch_files)
add_dependencies(test_launch_files demo_pusher)
rigid_body_rostest(monitor)
rigid_body_rostest(process)
rigid_body_rostest(replay)
target_link_libraries(test_replay rigid_body_sim_bag)
add_dependencies(test_replay simulate)
rigid_body_rostest(reset)
rigid_body_rostest(same_bytes)
rigid_body_rostest(rviz)
# the viewers' side of the handles
find_package(interactive_markers REQUIRED)
target_include_directories(test_rviz SYSTEM PRIVATE ${interactive_markers_INCLUDE_DIRS})
target_link_libraries(test_rviz ${interactive_markers_LIBRARIES})
rigid_body_rostest(services)
rigid_body_rostest(state_topics)
rigid_body_rostest(wrench_services)

# for scripts/soak
add_executable(garbage EXCLUDE_FROM_ALL test/soak/garbage.cpp)
target_link_libraries(garbage rigid_body_sim_ros rigid_body_compile_options)
# for scripts/measure_load
add_executable(node_load EXCLUDE_FROM_ALL test/benchmark/node_load.cpp)
target_link_libraries(node_load rigid_body_sim_ros rigid_body_compile_options)

# the same program, but the scene comes as text from a launch file
add_rostest(test/ros/remote.test DEPENDENCIES test_state_topics)

file(GLOB launch_files RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/launch/*.launch)
foreach(launch_file ${launch_files})
  roslaunch_add_file_check(${launch_file} IGNORE_UNSET_ARGS)
endforeach()
rigid_body_gtest(test_taylor
  SOURCES
    test/dynamics/test_taylor_accuracy.cpp
    test/dynamics/test_taylor_bound.cpp
    test/dynamics/test_taylor_segment.cpp
  LIBRARIES rigid_body_sim_core)
target_include_directories(test_taylor PRIVATE src)

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

rigid_body_gtest(test_extremes
  SOURCES
    test/extremes/test_extremes.cpp
  LIBRARIES rigid_body_extremes)

rigid_body_gtest(test_apart
  SOURCES
    test/extremes/apart.cpp
    test/extremes/test_apart.cpp
  LIBRARIES rigid_body_compile_options)
