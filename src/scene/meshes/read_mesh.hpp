#pragma once

#include <string>

#include "scene/meshes/file_mesh.hpp"

namespace rigid_body_sim {

/// What the name of a file ends in, from its last dot on, in lower case.
std::string extensionOf(const std::string& path);

/// Triangles of a mesh file: STL (ascii or binary), OBJ or DAE, told apart by the extension in
/// either case. Coordinates are multiplied by the scale of their axis, none of them zero; where it
/// mirrors (negative product), each triangle is turned round, so that its outside stays outside.
/// Polygons are divided into triangles; points and lines are left out. The surface is the one that
/// rviz draws: COLLADA's transforms and unit apply, its up axis does not. Coordinates are the
/// nearest doubles to those of a text. Vertices are as in the file, repeated for STL: see
/// checkedMesh.
///
/// Throws std::runtime_error with one line, the path first, for a file that is missing, is no
/// regular file, is beyond limits.hpp, is shorter than it claims, cannot be parsed, holds a
/// coordinate that is not finite, or holds no triangle.
FileMesh readMesh(const std::string& path, const Vector3d& scale = Vector3d::Ones());

}  // namespace rigid_body_sim
