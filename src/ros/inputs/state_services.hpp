#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "ros/inputs/inputs.hpp"
#include "ros/inputs/state_requests.hpp"

namespace rigid_body_sim {

/// The services ~set_state and ~get_state.
class StateServices {
 public:
  /// body_frames: on tf. Simulation and inputs are referred to, not copied.
  StateServices(ros::NodeHandle private_nh, const std::string& world_frame,
                const std::vector<std::string>& body_frames, const Simulation& simulation,
                Inputs& inputs);

 private:
  bool set(SetState::Request& request, SetState::Response& response);
  bool get(GetState::Request& request, GetState::Response& response);

  std::string world_frame_;
  std::vector<std::string> body_frames_;
  const Simulation& simulation_;
  Inputs& inputs_;
  ros::ServiceServer set_;
  ros::ServiceServer get_;
};

}  // namespace rigid_body_sim
