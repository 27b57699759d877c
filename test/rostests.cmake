# rostests: the node in a process of its own, driven through its topics and services. One program
# holds them all, since each of its own would compile and link ROS once more; each NAME.test starts
# a node and runs the suites that it names.
find_package(rostest REQUIRED)
find_package(roslaunch REQUIRED)
find_package(interactive_markers REQUIRED)  # the viewers' side of the handles
set(target rigid_body_sim_node_tests)
file(GLOB rostests RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS test/ros/node/*.test)
file(GLOB sources CONFIGURE_DEPENDS test/ros/node/test_*.cpp)
add_executable(${target} EXCLUDE_FROM_ALL test/ros/node/main.cpp ${sources})
set_target_properties(${target} PROPERTIES OUTPUT_NAME node_tests)
target_include_directories(${target} SYSTEM PRIVATE ${interactive_markers_INCLUDE_DIRS})
target_link_libraries(${target} PRIVATE rigid_body_sim_node_driver rigid_body_sim_bag
  ${interactive_markers_LIBRARIES} rigid_body_sim_options)
target_precompile_headers(${target} REUSE_FROM rigid_body_sim_node_driver)
target_compile_definitions(${target} PRIVATE ${program_definitions} GTEST_HAS_PTHREAD=1
  RIGID_BODY_SIM_FOLLOWER_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/follower.yaml"
  RIGID_BODY_SIM_IMU_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/imu.yaml"
  RIGID_BODY_SIM_MOTORS_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/motors.yaml"
  RIGID_BODY_SIM_ROSTESTS="${PROJECT_SOURCE_DIR}/test/ros/node"
  RIGID_BODY_SIM_TEST_SCENE="${PROJECT_SOURCE_DIR}/test/ros/node/lopsided.yaml")
target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0> $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
add_dependencies(tests ${target})
# under a sanitizer few of them run, and most need the node only
if(NOT RIGID_BODY_SIM_SANITIZE)
  add_dependencies(${target} ${programs})
endif()
foreach(rostest ${rostests})
  add_rostest(${rostest} DEPENDENCIES ${target})
endforeach()

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
