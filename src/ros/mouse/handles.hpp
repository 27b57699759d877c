#pragma once

#include <vector>

#include <visualization_msgs/InteractiveMarker.h>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// The handle of a body: a shell around what is drawn of it, to be grabbed anywhere and dragged in
/// the plane of the screen. Its name is the body's, and so is its frame: viewers carry it along
/// with tf, nothing is sent while the body moves.
visualization_msgs::InteractiveMarker toHandle(const BodyDef& def, const Body& body);

/// The handles of every body of the scene's world that moves.
std::vector<visualization_msgs::InteractiveMarker> toHandles(const Scene& scene,
                                                             const World& world);

}  // namespace rigid_body_sim
