#pragma once

#include <cstddef>

#include "dynamics/max_steps.hpp"  // kMaxSteps, of a run

namespace rigid_body_sim {

/// What a scene may hold at most. Each limit is far above what is simulated and low enough that any
/// file within it, however it was made, is read or refused within a few seconds and a gigabyte or
/// two; doc/robustness.md has the measurements. One more is refused in one line.

constexpr std::size_t kMaxSceneBytes = 64 << 20;  ///< of a scene's text
constexpr std::size_t kMaxDepth = 32;             ///< of lists and mappings in one another
constexpr std::size_t kMaxValues = 8000000;       ///< numbers, texts, lists and mappings
constexpr std::size_t kMaxTextBytes = 4096;       ///< of one text of a scene, such as a path
constexpr std::size_t kMaxNameBytes = 255;        ///< of the name of a body or point
constexpr std::size_t kMaxBodies = 200000;
constexpr std::size_t kMaxPoints = 10000;    ///< of a body
constexpr std::size_t kMaxActuators = 1000;  ///< of one kind, of a body
constexpr std::size_t kMaxImus = 1000;       ///< of a body
constexpr double kMaxImuRate = 1e6;          ///< [Hz]
constexpr std::size_t kMaxContactPairs = 200000;
constexpr std::size_t kMaxForces = 200000;
constexpr std::size_t kMaxCollisionShapes = 10000;  ///< of a body

constexpr std::size_t kMaxVariedPaths = 1000;  ///< of a study
constexpr std::size_t kMaxRecords = 1000;      ///< likewise

constexpr std::size_t kMaxUrdfBytes = 16 << 20;
constexpr std::size_t kMaxLinks = 10000;          ///< of a URDF file
constexpr std::size_t kMaxMeshBytes = 256 << 20;  ///< of STL and OBJ
constexpr std::size_t kMaxDaeBytes = 64 << 20;
constexpr std::size_t kMaxDaeNodes = 1000000;    ///< of a DAE file, every instance counted
constexpr std::size_t kMaxTriangles = 10000000;  ///< of a mesh
constexpr std::size_t kMaxXmlDepth = 100;  ///< of elements in one another, in URDF and DAE files

}  // namespace rigid_body_sim
