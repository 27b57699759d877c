#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <rigid_body_sim/SetPresent.h>

#include "ros/inputs/input_context.hpp"

namespace rigid_body_sim {

/// What ~set_present asks for. Throws std::invalid_argument, one line, for an unknown body, and for
/// a state that breaks a rule of ~set_state.
PresenceInput takePresence(const SetPresent::Request& request, const World& world,
                           const std::string& world_frame,
                           const std::vector<std::string>& body_frames = {});

/// The service ~set_present.
class PresenceService {
 public:
  /// body_frames: on tf. What the context refers to must outlive it.
  PresenceService(ros::NodeHandle private_nh, const std::string& world_frame,
                  const std::vector<std::string>& body_frames, const InputContext& context);

 private:
  bool set(SetPresent::Request& request, SetPresent::Response& response);

  std::string world_frame_;
  std::vector<std::string> body_frames_;
  InputContext context_;
  ros::ServiceServer server_;
};

}  // namespace rigid_body_sim
