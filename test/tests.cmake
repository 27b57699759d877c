# catkin before 0.8.10 gives its targets of an installed googletest the names of several libraries, or
# of none, in place of a file.
foreach(library gtest gtest_main gmock gmock_main)
  if(NOT TARGET ${library})
    continue()  # a library that the linker finds
  endif()
  get_target_property(type ${library} TYPE)
  if(type STREQUAL INTERFACE_LIBRARY)
    continue()  # without a file; CMake before 3.19 takes the question for a fault
  endif()
  get_target_property(imported ${library} IMPORTED)
  get_target_property(location ${library} IMPORTED_LOCATION)
  if(imported AND NOT EXISTS "${location}")
    find_library(RIGID_BODY_SIM_${library} ${library} REQUIRED)
    set_target_properties(${library} PROPERTIES
      IMPORTED_LOCATION "${RIGID_BODY_SIM_${library}}")
  endif()
endforeach()

# What drives the node in tests.
add_library(rigid_body_sim_node_driver STATIC EXCLUDE_FROM_ALL
  test/ros/node/node_driver.cpp test/ros/node/reference_run.cpp)
target_include_directories(rigid_body_sim_node_driver PUBLIC test)
target_link_libraries(rigid_body_sim_node_driver
  PUBLIC rigid_body_sim_ros gtest PRIVATE rigid_body_sim_options)
# compiled as the tests are that share its precompiled header: these wait for the node or a program,
# so that optimising them saves nothing, and takes a quarter of the compiler's time
target_compile_definitions(rigid_body_sim_node_driver PRIVATE GTEST_HAS_PTHREAD=1)
target_compile_options(rigid_body_sim_node_driver PRIVATE $<$<CONFIG:Release>:-O0>)
target_precompile_headers(rigid_body_sim_node_driver
  PRIVATE ${precompiled_ros_headers} <gtest/gtest.h>)

# All gtests that need no ROS master. The names of those that test the libraries are listed in
# gtests.txt of the build directory: they run a second time on libraries that are sanitized.
file(WRITE ${CMAKE_BINARY_DIR}/gtests.txt "")

# A program for each folder of tests, or for the files given. catkin's gtest targets take the plain
# signature of target_link_libraries.
function(rigid_body_sim_gtest name)
  cmake_parse_arguments(ARG "WITHOUT_LIBRARIES" "HEADERS_OF" "FOLDERS;SOURCES;LIBRARIES" ${ARGN})
  set(target rigid_body_sim_test_${name})
  foreach(folder ${ARG_FOLDERS})
    file(GLOB sources CONFIGURE_DEPENDS test/${folder}/test_*.cpp)
    list(APPEND ARG_SOURCES ${sources})
  endforeach()
  catkin_add_gtest(${target} ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE test)
  # as some releases of googletest say by themselves: whoever shares a precompiled header must agree
  target_compile_definitions(${target} PRIVATE GTEST_HAS_PTHREAD=1)
  target_link_libraries(${target} ${ARG_LIBRARIES} rigid_body_sim_options gtest_main gmock gtest)
  # in a unity build a fixture in an anonymous namespace stands in an included file: no fault
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  # What is tested is compiled as users compile it. Optimising the tests themselves takes longer than
  # it saves, but for the references of the core's: without, those take ten times as long.
  if(ARG_HEADERS_OF)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
    target_precompile_headers(${target} REUSE_FROM ${ARG_HEADERS_OF})
  else()
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    if(name STREQUAL math)
      target_precompile_headers(${target} PRIVATE ${precompiled_headers} <gtest/gtest.h>)
    elseif(NOT RIGID_BODY_SIM_SANITIZE)  # else one program would be built for another's header
      target_precompile_headers(${target} REUSE_FROM rigid_body_sim_test_math)
    endif()
  endif()
  if(NOT ARG_WITHOUT_LIBRARIES)
    file(APPEND ${CMAKE_BINARY_DIR}/gtests.txt "${target}\n")
  endif()
endfunction()

rigid_body_sim_gtest(math FOLDERS math LIBRARIES rigid_body_sim_core)
if(NOT RIGID_BODY_SIM_SANITIZE)  # as above; the tests of math, whose header it is, do without it
  target_compile_definitions(rigid_body_sim_test_support PRIVATE GTEST_HAS_PTHREAD=1)
  target_precompile_headers(rigid_body_sim_test_support REUSE_FROM rigid_body_sim_test_math)
endif()
rigid_body_sim_gtest(mass FOLDERS mass LIBRARIES rigid_body_sim_core)
rigid_body_sim_gtest(rotation FOLDERS dynamics/rotation LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(taylor FOLDERS dynamics/taylor LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(dynamics
  FOLDERS dynamics/laws dynamics/methods dynamics/run dynamics/wrenches
  LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(contact FOLDERS dynamics/contact LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(packs FOLDERS dynamics/packs LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(pivot FOLDERS dynamics/pivot LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(imu FOLDERS dynamics/imu LIBRARIES rigid_body_sim_test_support)
rigid_body_sim_gtest(motors FOLDERS dynamics/motors LIBRARIES rigid_body_sim_test_support)
# without the library of the support, which the build under the thread sanitizer does not need
rigid_body_sim_gtest(threads FOLDERS dynamics/threads LIBRARIES rigid_body_sim_core)
rigid_body_sim_gtest(scene FOLDERS scene LIBRARIES rigid_body_sim_scene)
target_include_directories(rigid_body_sim_test_scene SYSTEM PRIVATE ${URDF_MODEL_INCLUDE_DIR})
target_compile_definitions(rigid_body_sim_test_scene PRIVATE
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes")
rigid_body_sim_gtest(node
  FOLDERS ros LIBRARIES rigid_body_sim_ros HEADERS_OF rigid_body_sim_node_driver)

# programs that tests run, by the name of a definition
set(program_definitions
  RIGID_BODY_SIM_COMPARE_RUNS="$<TARGET_FILE:rigid_body_sim_compare_runs>"
  RIGID_BODY_SIM_CONFIG="${PROJECT_SOURCE_DIR}/config"
  RIGID_BODY_SIM_SCENES="${PROJECT_SOURCE_DIR}/config/scenes"
  RIGID_BODY_SIM_DEMO_PUSHER="$<TARGET_FILE:rigid_body_sim_demo_pusher>"
  RIGID_BODY_SIM_DRONE_PILOT="$<TARGET_FILE:rigid_body_sim_drone_pilot>"
  RIGID_BODY_SIM_MASS_PROPERTIES="$<TARGET_FILE:rigid_body_sim_mass_properties>"
  RIGID_BODY_SIM_NODE="$<TARGET_FILE:rigid_body_sim_rigid_body_node>"
  RIGID_BODY_SIM_PLOT="$<TARGET_FILE:rigid_body_sim_plot>"
  RIGID_BODY_SIM_SIMULATE="$<TARGET_FILE:rigid_body_sim_simulate>"
  RIGID_BODY_SIM_SWEEP="$<TARGET_FILE:rigid_body_sim_sweep>"
  RIGID_BODY_SIM_TRADE="$<TARGET_FILE:rigid_body_sim_trade>")

# ninja begins targets in this order: what takes longest to compile must not be the last
include(test/rostests.cmake)

rigid_body_sim_gtest(tools
  FOLDERS tools LIBRARIES rigid_body_sim_plots rigid_body_sim_test_support
  HEADERS_OF rigid_body_sim_node_driver)
target_compile_definitions(rigid_body_sim_test_tools PRIVATE ${program_definitions})
add_dependencies(rigid_body_sim_test_tools ${programs})

rigid_body_sim_gtest(trade
  FOLDERS tools/trade LIBRARIES rigid_body_sim_tools rigid_body_sim_test_support)
target_compile_definitions(rigid_body_sim_test_trade PRIVATE ${program_definitions})
add_dependencies(rigid_body_sim_test_trade rigid_body_sim_trade)

rigid_body_sim_gtest(sweep FOLDERS scene/study tools/sweep LIBRARIES rigid_body_sim_tools)
target_compile_definitions(rigid_body_sim_test_sweep PRIVATE ${program_definitions})
add_dependencies(rigid_body_sim_test_sweep rigid_body_sim_sweep rigid_body_sim_simulate)

# Boost and GSL are other people's elliptic functions to compare with; nothing else needs them.
find_package(GSL REQUIRED)
rigid_body_sim_gtest(elliptic
  WITHOUT_LIBRARIES FOLDERS math/elliptic LIBRARIES rigid_body_sim_core GSL::gsl)
rigid_body_sim_gtest(extremes
  SOURCES test/extremes/test_extremes.cpp LIBRARIES rigid_body_sim_extreme_cases)
rigid_body_sim_gtest(apart
  WITHOUT_LIBRARIES SOURCES test/extremes/apart.cpp test/extremes/test_apart.cpp LIBRARIES rigid_body_sim_options)
