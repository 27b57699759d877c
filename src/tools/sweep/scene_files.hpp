#pragma once

#include <string>
#include <vector>

#include "scene/readers/read_context.hpp"

namespace rigid_body_sim {

/// A digest of each file that was read for a scene, or may be for another choice of links: meshes,
/// URDF files, and the meshes that these say touch; "none" of a file that cannot be read, which not
/// every choice needs. Their order does not depend on where the files are: on another host they may
/// be in another directory.
std::vector<std::string> digestsOfFiles(const ReadContext& context);

}  // namespace rigid_body_sim
