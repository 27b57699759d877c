#pragma once

#include <cstddef>

namespace rigid_body_sim {

/// What a scene may hold at most. Each limit is far above what is simulated and low enough that any
/// file within it, however it was made, is read or refused within a few seconds and a gigabyte or
/// two; doc/robustness.md has the measurements. One more is refused in one line.

constexpr std::size_t kMostSceneBytes = 64 << 20;  ///< of a scene's text
constexpr std::size_t kMostDepth = 32;             ///< of lists and mappings in one another
constexpr std::size_t kMostValues = 8000000;       ///< numbers, texts, lists and mappings
constexpr std::size_t kMostTextBytes = 4096;       ///< of one text of a scene, such as a path
constexpr std::size_t kMostNameBytes = 255;        ///< of the name of a body or point
constexpr std::size_t kMostBodies = 200000;
constexpr std::size_t kMostPoints = 10000;  ///< of a body
constexpr std::size_t kMostForces = 200000;
constexpr double kMostSteps = 9007199254740992;  ///< 2⁵³: no double counts on by ones from there

constexpr std::size_t kMostUrdfBytes = 16 << 20;
constexpr std::size_t kMostLinks = 10000;          ///< of a URDF file
constexpr std::size_t kMostMeshBytes = 256 << 20;  ///< of STL and OBJ
constexpr std::size_t kMostDaeBytes = 64 << 20;
constexpr std::size_t kMostDaeNodes = 1000000;    ///< of a DAE file, every instance counted
constexpr std::size_t kMostTriangles = 10000000;  ///< of a mesh
constexpr std::size_t kMostXmlDepth = 100;  ///< of elements in one another, in URDF and DAE files

}  // namespace rigid_body_sim
