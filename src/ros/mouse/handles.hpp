#pragma once

#include <string>
#include <vector>

#include <visualization_msgs/InteractiveMarker.h>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "ros/messages/tf_frames.hpp"

namespace rigid_body_sim {

/// The handle of a body: a shell around what is drawn of it, to be grabbed anywhere and dragged in
/// the plane of the screen, with a menu (menuEntries). Its name is the body's, and its frame the
/// body's on tf: viewers carry it along, nothing is sent while the body moves.
visualization_msgs::InteractiveMarker toHandle(const BodyDef& def, const Body& body,
                                               const std::string& frame);
inline visualization_msgs::InteractiveMarker toHandle(const BodyDef& def, const Body& body) {
  return toHandle(def, body, def.name);
}

/// The handles of every body of the scene's world that moves.
std::vector<visualization_msgs::InteractiveMarker> toHandles(const Scene& scene, const World& world,
                                                             const TfFrames& frames);
inline std::vector<visualization_msgs::InteractiveMarker> toHandles(const Scene& scene,
                                                                    const World& world) {
  return toHandles(scene, world, TfFrames(scene));
}

}  // namespace rigid_body_sim
