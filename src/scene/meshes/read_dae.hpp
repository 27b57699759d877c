#pragma once

#include <string>

#include "scene/meshes/file_mesh.hpp"

namespace rigid_body_sim {

/// The triangles of a COLLADA file from its text, in double precision: those that its scene shows,
/// with instances of nodes and geometries expanded, placed by the transforms of their nodes and in
/// metres by the unit of the file. Its up axis has no part; a skin is taken in its bind pose.
/// Throws std::runtime_error with one line for a text that cannot be parsed or is nested too deep
/// (xmlFault), for nodes that lie within themselves, and for more nodes or triangles than
/// limits.hpp allows.
FileMesh readDae(const std::string& xml);

}  // namespace rigid_body_sim
