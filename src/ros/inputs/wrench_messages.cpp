#include "ros/inputs/wrench_messages.hpp"

#include <limits>

namespace rigid_body_sim {
namespace {

constexpr double kNextStep = -std::numeric_limits<double>::infinity();

}  // namespace

std::string slotOfId(const std::string& id) { return id.empty() ? "" : "id " + id; }

WrenchRequest toRequest(const std::string& body, const geometry_msgs::WrenchStamped& message) {
  WrenchRequest request;
  request.slot = "frame " + message.header.frame_id;
  request.placed_by_frame = true;
  request.wrench.body = body;
  request.wrench.frame = message.header.frame_id;
  request.wrench.force = fromVector3(message.wrench.force);
  request.wrench.torque = fromVector3(message.wrench.torque);
  request.wrench.start = kNextStep;
  return request;
}

WrenchRequest toRequest(const AppliedWrench& message, const TimeOrigin& origin) {
  WrenchRequest request;
  request.slot = slotOfId(message.id);
  request.wrench.body = message.body;
  request.wrench.frame = message.header.frame_id;
  request.wrench.point_frame = message.point_frame;
  request.wrench.point = fromPoint(message.point);
  request.wrench.force = fromVector3(message.wrench.force);
  request.wrench.torque = fromVector3(message.wrench.torque);
  request.wrench.start = message.start.isZero() ? kNextStep : origin.simulationTime(message.start);
  request.wrench.duration = toSeconds(message.duration);
  return request;
}

}  // namespace rigid_body_sim
