#pragma once

#include <string>
#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/scene/scene.hpp>

#include "ros/messages/tf_frames.hpp"

namespace rigid_body_sim {

/// Markers of a body in its own frame, so that they follow tf and are sent once: what visualsOf
/// says there is to draw. frame: its name on tf.
std::vector<visualization_msgs::Marker> toMarkers(const BodyDef& body, const std::string& frame);

/// The markers of every body.
visualization_msgs::MarkerArray toMarkers(const Scene& scene, const TfFrames& frames);
inline visualization_msgs::MarkerArray toMarkers(const Scene& scene) {
  return toMarkers(scene, TfFrames(scene));
}

}  // namespace rigid_body_sim
