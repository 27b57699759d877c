#pragma once

#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The triangles of a COLLADA file from its text, by assimp: its transforms and unit apply, its up
/// axis does not. Coordinates come in single precision. Throws std::runtime_error with one line for
/// a text that cannot be parsed or is nested too deep (xmlFault).
TriangleMesh readDae(const std::string& xml);

}  // namespace rigid_body_sim
