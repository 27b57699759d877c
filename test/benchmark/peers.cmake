# benchmark_peers: ours beside those engines that are installed; benchmark_crowds: the same with many
# bodies in one world; extremes_engines: they in the cells of the map of the extremes. None of them is a dependency of the package; Debian's packages:
# libboost-dev libbullet-dev libode-dev libdart-dev libsimbody-dev.
rigid_body_sim_benchmark(benchmark_peers
  SOURCES test/benchmark/peers.cpp test/benchmark/peers_cases.cpp test/benchmark/peers_engines.cpp
          test/benchmark/peers_ours.cpp test/benchmark/peers_truth.cpp
  LIBRARIES rigid_body_sim_core)
rigid_body_sim_benchmark(extremes_engines
  SOURCES test/benchmark/peers_engines.cpp test/extremes/apart.cpp test/extremes/engines.cpp
  LIBRARIES rigid_body_sim_extreme_cases)

rigid_body_sim_benchmark(benchmark_crowds
  SOURCES test/benchmark/crowds.cpp test/benchmark/peers_engines.cpp test/benchmark/peers_ours.cpp
  LIBRARIES rigid_body_sim_core)

# benchmark_touch_peers: the same engines, where bodies touch the ground
rigid_body_sim_benchmark(benchmark_touch_peers
  SOURCES test/benchmark/touch_peers.cpp test/benchmark/touch_peers_ours.cpp
          test/benchmark/touch_peers_rattleback.cpp
  LIBRARIES rigid_body_sim_test_support)
# each engine has names and macros of its own
set_target_properties(rigid_body_sim_benchmark_peers rigid_body_sim_benchmark_crowds
  rigid_body_sim_benchmark_touch_peers rigid_body_sim_extremes_engines PROPERTIES UNITY_BUILD OFF)

function(rigid_body_sim_peer name)
  cmake_parse_arguments(ARG "" "" "INCLUDES;LIBRARIES" ${ARGN})
  message(STATUS "benchmark_peers: with ${name}")
  foreach(program rigid_body_sim_benchmark_peers rigid_body_sim_benchmark_crowds
          rigid_body_sim_extremes_engines)
    target_sources(${program} PRIVATE test/benchmark/peers_${name}.cpp)
    target_include_directories(${program} SYSTEM PRIVATE ${ARG_INCLUDES})
    target_link_libraries(${program} PRIVATE ${ARG_LIBRARIES})
  endforeach()
  set(touch test/benchmark/touch_peers_${name}.cpp)
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${touch})  # a mere integrator
    return()
  endif()
  target_sources(rigid_body_sim_benchmark_touch_peers PRIVATE ${touch})
  target_include_directories(rigid_body_sim_benchmark_touch_peers SYSTEM PRIVATE ${ARG_INCLUDES})
  target_link_libraries(rigid_body_sim_benchmark_touch_peers PRIVATE ${ARG_LIBRARIES})
endfunction()

find_package(Boost QUIET)
if(Boost_FOUND)
  rigid_body_sim_peer(odeint INCLUDES ${Boost_INCLUDE_DIRS})
  # for this very processor, fused multiply-adds included; its own headers do not pass our warnings
  set_source_files_properties(test/benchmark/peers_odeint.cpp PROPERTIES COMPILE_OPTIONS
    "-O3;-march=native;-ffp-contract=fast;-Wno-uninitialized;-Wno-maybe-uninitialized")
endif()

# in double precision, which Debian packages beside the usual one
find_path(BULLET_INCLUDE_DIR btBulletDynamicsCommon.h PATH_SUFFIXES bullet)
find_library(BULLET_DYNAMICS_LIBRARY BulletDynamics-float64)
find_library(BULLET_COLLISION_LIBRARY BulletCollision-float64)
find_library(BULLET_MATH_LIBRARY LinearMath-float64)
if(BULLET_INCLUDE_DIR AND BULLET_DYNAMICS_LIBRARY AND BULLET_COLLISION_LIBRARY
   AND BULLET_MATH_LIBRARY)
  rigid_body_sim_peer(bullet INCLUDES ${BULLET_INCLUDE_DIR}
    LIBRARIES ${BULLET_DYNAMICS_LIBRARY} ${BULLET_COLLISION_LIBRARY} ${BULLET_MATH_LIBRARY})
  set_source_files_properties(
    test/benchmark/peers_bullet.cpp test/benchmark/touch_peers_bullet.cpp PROPERTIES
    COMPILE_DEFINITIONS BT_USE_DOUBLE_PRECISION)
endif()

find_path(ODE_INCLUDE_DIR ode/ode.h)
find_library(ODE_LIBRARY ode)
if(ODE_INCLUDE_DIR AND ODE_LIBRARY)
  rigid_body_sim_peer(ode INCLUDES ${ODE_INCLUDE_DIR} LIBRARIES ${ODE_LIBRARY})
endif()

find_path(DART_INCLUDE_DIR dart/dart.hpp)
find_library(DART_LIBRARY dart)
if(DART_INCLUDE_DIR AND DART_LIBRARY)
  rigid_body_sim_peer(dart INCLUDES ${DART_INCLUDE_DIR} LIBRARIES ${DART_LIBRARY})
endif()

find_package(Simbody QUIET)
if(Simbody_FOUND)
  rigid_body_sim_peer(simbody INCLUDES ${Simbody_INCLUDE_DIR} LIBRARIES ${Simbody_LIBRARIES})
endif()
