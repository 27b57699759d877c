#pragma once

#include <string>

#include <geometry_msgs/Vector3Stamped.h>
#include <ros/node_handle.h>

#include "ros/inputs/input_context.hpp"

namespace rigid_body_sim {

/// The velocity of the medium that a message sets from now on. Throws std::invalid_argument where
/// it is not given in the world frame.
WindInput takeWind(const geometry_msgs::Vector3Stamped& message, const std::string& world_frame);

/// The topic ~wind, in a scene that names a medium.
class WindInterface {
 public:
  /// What the context refers to must outlive it.
  WindInterface(const ros::NodeHandle& private_nh, const std::string& world_frame,
                const InputContext& context);

 private:
  ros::Subscriber wind_;
};

}  // namespace rigid_body_sim
