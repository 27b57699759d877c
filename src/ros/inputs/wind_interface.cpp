#include "ros/inputs/wind_interface.hpp"

#include <array>
#include <stdexcept>

#include "ros/messages/conversions.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {

WindInput takeWind(const geometry_msgs::Vector3Stamped& message, const std::string& world_frame) {
  if (message.header.frame_id != world_frame)
    throw std::invalid_argument("header.frame_id must be the world frame '" + world_frame +
                                "', got '" + printable(message.header.frame_id) + "'");
  return {fromVector3(message.vector)};
}

WindInterface::WindInterface(const ros::NodeHandle& private_nh, const std::string& world_frame,
                             const InputContext& context) {
  if (!context.simulation.world().has_medium) return;
  using Message = geometry_msgs::Vector3Stamped;
  wind_ = context.subscribe<Message>(
      private_nh, "wind", [world_frame, context](const Message& message) {
        context.apply("wind", [&](double) { return std::array{takeWind(message, world_frame)}; });
      });
}

}  // namespace rigid_body_sim
