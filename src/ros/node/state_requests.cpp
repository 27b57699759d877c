#include "ros/node/state_requests.hpp"

#include <sstream>

#include <rigid_body_sim/math/rotation.hpp>

#include "ros/messages/body_index.hpp"
#include "ros/messages/conversions.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Fault of the body, and of the axes of its twist.
std::string namesFault(const std::string& body, const std::string& frame, const World& world,
                       const std::string& world_frame) {
  if (indexOf(body, world.bodies) == world.bodies.size())
    return "unknown body '" + printable(body) + "'";
  if (frame == world_frame || frame == body) return "";
  return "frame must be '" + world_frame + "' or '" + body + "', got '" + printable(frame) + "'";
}

std::string finiteFault(const char* name, const Vector3d& v) {
  return v.allFinite() ? "" : std::string(name) + " must be finite";
}

std::string orientationFault(const geometry_msgs::Quaternion& q) {
  const Quaterniond quaternion(q.w, q.x, q.y, q.z);
  if (isNearlyUnit(quaternion)) return "";
  std::ostringstream fault;
  fault << "pose.orientation must be a unit quaternion, got norm " << quaternion.norm();
  return fault.str();
}

bool isFinite(const BodyState& s) {
  return s.x_W.allFinite() && s.p_W.allFinite() && s.L_W.allFinite() && s.L_P.allFinite();
}

std::string faultOf(const SetState::Request& request, const World& world,
                    const std::string& world_frame) {
  for (const std::string& fault :
       {namesFault(request.body, request.frame, world, world_frame),
        finiteFault("pose.position", fromPoint(request.pose.position)),
        orientationFault(request.pose.orientation),
        finiteFault("twist.linear", fromVector3(request.twist.linear)),
        finiteFault("twist.angular", fromVector3(request.twist.angular))}) {
    if (!fault.empty()) return fault;
  }
  if (world.bodies[indexOf(request.body, world.bodies)].fixed)
    return "body '" + request.body + "' is fixed";
  return "";
}

}  // namespace

RequestedState takeState(const SetState::Request& request, const World& world,
                         const std::string& world_frame) {
  RequestedState requested;
  requested.fault = faultOf(request, world, world_frame);
  if (!requested.fault.empty()) return requested;

  const geometry_msgs::Quaternion& q = request.pose.orientation;
  BodyFrameMotion motion;
  motion.x_W = fromPoint(request.pose.position);
  motion.q_WB = Quaterniond(q.w, q.x, q.y, q.z).normalized();
  motion.v_W = fromVector3(request.twist.linear);
  motion.w_W = fromVector3(request.twist.angular);
  if (request.frame != world_frame) {
    motion.v_W = rotate(motion.q_WB, motion.v_W);
    motion.w_W = rotate(motion.q_WB, motion.w_W);
  }
  requested.body = indexOf(request.body, world.bodies);
  requested.state = toBodyState(world.bodies[requested.body], motion);
  if (!isFinite(requested.state)) requested.fault = "the state must have a finite momentum";
  return requested;
}

GetState::Response tellState(const GetState::Request& request, const World& world,
                             const State& state, const std::string& world_frame) {
  GetState::Response response;
  response.message = namesFault(request.body, request.frame, world, world_frame);
  response.success = response.message.empty();
  if (!response.success) return response;

  const std::size_t i = indexOf(request.body, world.bodies);
  const Body& body = world.bodies[i];
  const BodyFrameMotion motion = toBodyFrameMotion(body, state.bodies[i]);
  response.pose = toPose(motion);
  if (request.frame == world_frame) {
    response.twist.linear = toVector3(motion.v_W);
    response.twist.angular = toVector3(motion.w_W);
  } else {
    response.twist = toTwistInBodyAxes(body, state.bodies[i]);
  }
  return response;
}

}  // namespace rigid_body_sim
