#include "ros/inputs/presence_service.hpp"

#include <array>

#include "ros/inputs/state_requests.hpp"
#include "ros/messages/body_index.hpp"

namespace rigid_body_sim {

PresenceInput takePresence(const SetPresent::Request& request, const World& world,
                           const std::string& world_frame,
                           const std::vector<std::string>& body_frames) {
  if (!request.present) return {bodyNamed(request.body, world.bodies), std::nullopt};
  SetState::Request state;
  state.body = request.body;
  state.frame = request.frame;
  state.pose = request.pose;
  state.twist = request.twist;
  const StateInput input = takeState(state, world, world_frame, body_frames);
  return {input.body, input.motion};
}

PresenceService::PresenceService(ros::NodeHandle private_nh, const std::string& world_frame,
                                 const std::vector<std::string>& body_frames,
                                 const InputContext& context)
    : world_frame_(world_frame),
      body_frames_(body_frames),
      context_(context),
      server_(private_nh.advertiseService("set_present", &PresenceService::set, this)) {}

bool PresenceService::set(SetPresent::Request& request, SetPresent::Response& response) {
  response.message = context_.apply("set_present", [&](double) {
    return std::array{
        takePresence(request, context_.simulation.world(), world_frame_, body_frames_)};
  });
  response.success = response.message.empty();
  return true;
}

}  // namespace rigid_body_sim
