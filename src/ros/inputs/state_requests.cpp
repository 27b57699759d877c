#include "ros/inputs/state_requests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <rigid_body_sim/math/rotation.hpp>

#include "ros/messages/body_index.hpp"
#include "ros/messages/conversions.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Whether the twist is in the axes of the body; else it is in the world's. Names come before the
/// words `world` and `body`, which a body may have as its name, too.
bool isInBodyAxes(const std::string& frame, std::size_t i, const World& world,
                  const std::string& world_frame, const std::vector<std::string>& body_frames) {
  const std::string& body = world.bodies[i].name;
  if (frame == body) return true;
  if (frame == world_frame) return false;
  const bool names_another = std::any_of(world.bodies.begin(), world.bodies.end(),
                                         [&](const Body& other) { return other.name == frame; });
  if (!names_another) {
    if (frame == "body" || (i < body_frames.size() && frame == body_frames[i])) return true;
    if (frame == "world") return false;
  }
  const auto named = [](const std::string& own, const std::string& general) {
    return "'" + own + "'" + (own == general ? "" : " or '" + general + "'");
  };
  throw std::invalid_argument("frame must be that of the world, " + named(world_frame, "world") +
                              ", or of the body, " + named(body, "body") + ", got '" +
                              printable(frame) + "'");
}

void requireFinite(const char* name, const Vector3d& v) {
  if (!v.allFinite())
    throw std::invalid_argument(std::string(name) + " must be finite, got " + listed(v));
}

/// The quaternion, normalised unless it is unit to rounding, so that a recorded one keeps its bits.
Quaterniond unitOf(const geometry_msgs::Quaternion& message) {
  const Quaterniond q(message.w, message.x, message.y, message.z);
  if (!isNearlyUnit(q)) {
    std::ostringstream fault;
    fault << "pose.orientation must be a unit quaternion, got norm " << q.norm();
    throw std::invalid_argument(fault.str());
  }
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  return std::abs(q.squaredNorm() - 1) <= kRounding ? q : Quaterniond(q.normalized());
}

bool isFinite(const BodyState& s) {
  return s.x_W.allFinite() && s.p_W.allFinite() && s.L_W.allFinite() && s.L_P.allFinite();
}

}  // namespace

StateInput takeState(const SetState::Request& request, const World& world,
                     const std::string& world_frame, const std::vector<std::string>& body_frames) {
  StateInput input;
  input.body = bodyNamed(request.body, world.bodies);
  const Body& body = world.bodies[input.body];
  const bool in_body_axes =
      isInBodyAxes(request.frame, input.body, world, world_frame, body_frames);
  BodyFrameMotion& motion = input.motion;
  motion.x_W = fromPoint(request.pose.position);
  motion.v_W = fromVector3(request.twist.linear);
  motion.w_W = fromVector3(request.twist.angular);
  requireFinite("pose.position", motion.x_W);
  motion.q_WB = unitOf(request.pose.orientation);
  requireFinite("twist.linear", motion.v_W);
  requireFinite("twist.angular", motion.w_W);
  if (body.fixed) throw std::invalid_argument("body '" + request.body + "' is fixed");
  if (in_body_axes) {
    motion.v_W = rotate(motion.q_WB, motion.v_W);
    motion.w_W = rotate(motion.q_WB, motion.w_W);
  }
  if (!isFinite(toBodyState(body, motion)))
    throw std::invalid_argument("the state must have a finite momentum");
  return input;
}

GetState::Response reportState(const GetState::Request& request, const World& world,
                               const State& state, const std::string& world_frame,
                               const std::vector<std::string>& body_frames) {
  const std::size_t i = bodyNamed(request.body, world.bodies);
  const bool in_body_axes = isInBodyAxes(request.frame, i, world, world_frame, body_frames);
  const Body& body = world.bodies[i];
  if (body.absent) throw std::invalid_argument("body '" + request.body + "' is absent");
  const BodyFrameMotion motion = toBodyFrameMotion(body, state.bodies[i]);
  GetState::Response response;
  response.success = true;
  response.pose = toPose(motion);
  if (in_body_axes) {
    response.twist = toTwistInBodyAxes(body, state.bodies[i]);
  } else {
    response.twist.linear = toVector3(motion.v_W);
    response.twist.angular = toVector3(motion.w_W);
  }
  return response;
}

}  // namespace rigid_body_sim
