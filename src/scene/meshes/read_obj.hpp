#pragma once

#include <string>

#include "scene/meshes/file_mesh.hpp"

namespace rigid_body_sim {

/// The surface of a Wavefront OBJ file from its text: vertices (v) and faces (f). What else such a
/// file holds has no part in a solid. A polygon becomes the fan of triangles about its first
/// corner; volume and moments of a plane polygon are those of its fan, concave or not.
///
/// Throws std::runtime_error with one line for what is no number, a face of fewer than three
/// corners, a corner that no vertex before it has, and a vertex with a weight other than one.
FileMesh readObj(std::string text);

}  // namespace rigid_body_sim
