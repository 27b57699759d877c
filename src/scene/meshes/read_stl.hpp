#pragma once

#include <string>

#include "scene/meshes/file_mesh.hpp"

namespace rigid_body_sim {

/// The triangles of an STL file, ascii or binary, from its bytes. Normals, names and attributes
/// have no part in a solid. Throws std::runtime_error with one line for bytes that end before what
/// they claim, and for words that are not STL's.
FileMesh readStl(const std::string& bytes);

}  // namespace rigid_body_sim
