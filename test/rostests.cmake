# rostests: the node in a process of its own, driven through its topics and services. Each is
# test/ros/node/NAME.test with its program test_NAME.cpp beside it.
find_package(rostest REQUIRED)
find_package(roslaunch REQUIRED)
function(rigid_body_sim_rostest name)
  set(target rigid_body_sim_test_${name})
  add_rostest_gtest(${target} test/ros/node/${name}.test test/ros/node/test_${name}.cpp)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME test_${name} UNITY_BUILD OFF)
  target_link_libraries(${target} rigid_body_sim_node_driver ${ARGN} rigid_body_sim_options)
  target_precompile_headers(${target} REUSE_FROM rigid_body_sim_node_driver)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  # under a sanitizer few of them run, and most need the node only
  if(NOT RIGID_BODY_SIM_SANITIZE)
    add_dependencies(${target} ${programs})
  endif()
  target_compile_definitions(${target} PRIVATE ${program_definitions}
    RIGID_BODY_SIM_FOLLOWER_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/follower.yaml"
    RIGID_BODY_SIM_MOTORS_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/motors.yaml"
    RIGID_BODY_SIM_TEST_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/lopsided.yaml")
endfunction()
rigid_body_sim_rostest(between_steps)
rigid_body_sim_rostest(clock)
rigid_body_sim_rostest(commands rigid_body_sim_bag)
rigid_body_sim_rostest(doors)
rigid_body_sim_rostest(fleet)
rigid_body_sim_rostest(imu_topics)
rigid_body_sim_rostest(launch_files)
rigid_body_sim_rostest(live)
rigid_body_sim_rostest(lockstep)
rigid_body_sim_rostest(lockstep_clock)
rigid_body_sim_rostest(monitor)
rigid_body_sim_rostest(paused)
rigid_body_sim_rostest(process)
rigid_body_sim_rostest(replay rigid_body_sim_bag)
rigid_body_sim_rostest(reset)
rigid_body_sim_rostest(same_bytes)
rigid_body_sim_rostest(transport)
# the viewers' side of the handles
find_package(interactive_markers REQUIRED)
foreach(name body_set rviz)
  rigid_body_sim_rostest(${name} ${interactive_markers_LIBRARIES})
  target_include_directories(rigid_body_sim_test_${name} SYSTEM PRIVATE
    ${interactive_markers_INCLUDE_DIRS})
endforeach()
rigid_body_sim_rostest(services)
rigid_body_sim_rostest(state_topics)
rigid_body_sim_rostest(wrench_services)

# the same program, but the scene comes as text from a launch file
add_rostest(test/ros/node/remote.test DEPENDENCIES rigid_body_sim_test_state_topics)

file(GLOB launch_files RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/launch/*.launch)
foreach(launch_file ${launch_files})
  roslaunch_add_file_check(${launch_file} IGNORE_UNSET_ARGS)
endforeach()

# for scripts/soak
add_executable(rigid_body_sim_garbage EXCLUDE_FROM_ALL test/soak/garbage.cpp)
set_target_properties(rigid_body_sim_garbage PROPERTIES OUTPUT_NAME garbage)
target_link_libraries(rigid_body_sim_garbage rigid_body_sim_ros rigid_body_sim_options)
# for scripts/measure_load
add_executable(rigid_body_sim_node_load EXCLUDE_FROM_ALL test/benchmark/node_load.cpp)
set_target_properties(rigid_body_sim_node_load PROPERTIES OUTPUT_NAME node_load)
target_link_libraries(rigid_body_sim_node_load rigid_body_sim_ros rigid_body_sim_options)
# for scripts/measure_many_bodies
add_executable(rigid_body_sim_states_load EXCLUDE_FROM_ALL test/benchmark/states_load.cpp)
set_target_properties(rigid_body_sim_states_load PROPERTIES OUTPUT_NAME states_load)
target_link_libraries(rigid_body_sim_states_load rigid_body_sim_ros rigid_body_sim_options)
# what IMUs cost beyond their messages
add_executable(rigid_body_sim_benchmark_imu EXCLUDE_FROM_ALL test/benchmark/imu.cpp)
set_target_properties(rigid_body_sim_benchmark_imu PROPERTIES OUTPUT_NAME benchmark_imu)
target_link_libraries(rigid_body_sim_benchmark_imu rigid_body_sim_ros rigid_body_sim_options)
