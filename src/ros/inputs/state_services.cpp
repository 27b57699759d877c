#include "ros/inputs/state_services.hpp"

#include <stdexcept>

namespace rigid_body_sim {

StateServices::StateServices(ros::NodeHandle private_nh, const std::string& world_frame,
                             const std::vector<std::string>& body_frames,
                             const Simulation& simulation, Inputs& inputs)
    : world_frame_(world_frame),
      body_frames_(body_frames),
      simulation_(simulation),
      inputs_(inputs),
      set_(private_nh.advertiseService("set_state", &StateServices::set, this)),
      get_(private_nh.advertiseService("get_state", &StateServices::get, this)) {}

bool StateServices::set(SetState::Request& request, SetState::Response& response) {
  try {
    inputs_.apply(takeState(request, simulation_.world(), world_frame_, body_frames_));
    response.success = true;
  } catch (const std::invalid_argument& refused) {
    response.message = refused.what();
  }
  return true;
}

bool StateServices::get(GetState::Request& request, GetState::Response& response) {
  try {
    response =
        reportState(request, simulation_.world(), simulation_.state(), world_frame_, body_frames_);
  } catch (const std::invalid_argument& refused) {
    response.message = refused.what();
  }
  response.stamp = inputs_.stamp();
  return true;
}

}  // namespace rigid_body_sim
