#pragma once

#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The triangles of an STL file, ascii or binary, from its bytes. Normals, names and attributes
/// have no part in a solid. Throws std::runtime_error with one line for bytes that end before what
/// they claim, and for words that are not STL's.
TriangleMesh readStl(const std::string& bytes);

}  // namespace rigid_body_sim
