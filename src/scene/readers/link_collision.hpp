#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/entry.hpp"
#include "scene/urdf/fixed_links.hpp"

namespace rigid_body_sim {

/// The <collision> elements of links, in the body frame; reads their meshes. entry: the value of
/// `urdf`, which names the file at that path. Throws SceneError for an element that cannot be read:
/// the body would touch less than the file says.
std::vector<CollisionDef> collisionOf(const Entry& entry, const UrdfRobot& robot,
                                      const std::string& path,
                                      const std::vector<PlacedLink>& links);

}  // namespace rigid_body_sim
