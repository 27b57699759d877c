#include "ros/inputs/wrench_intake.hpp"

#include <limits>
#include <sstream>
#include <stdexcept>

#include <rigid_body_sim/scene/resolve_wrench.hpp>

#include "ros/inputs/start_of_input.hpp"
#include "ros/messages/tf_frames.hpp"
#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// The name of a slot is kept with every wrench that acts or is to come.
void requireShort(const char* key, const std::string& name) {
  if (name.size() <= kMaxTextBytes) return;
  throw std::invalid_argument(std::string(key) + " must have at most " +
                              std::to_string(kMaxTextBytes) + " bytes, got " +
                              std::to_string(name.size()));
}

/// Without an id, nothing could replace a wrench that is held.
void requireDuration(double duration, const std::string& id) {
  if (duration > 0 || (duration == 0 && !id.empty())) return;
  std::ostringstream fault;
  fault << "duration must be " << (id.empty() ? "> 0 s where id is empty" : ">= 0 s") << ", got "
        << duration;
  throw std::invalid_argument(fault.str());
}

/// [s] Wrenches may be scheduled long before, but no run takes years.
constexpr double kFarthestStart = 3e7;

}  // namespace

std::string slotOfId(const std::string& id) { return id.empty() ? "" : "id " + id; }

WrenchIntake::WrenchIntake(const Scene& scene, const std::vector<Body>& bodies,
                           double wrench_timeout, const std::string& tf_prefix)
    : bodies_(&bodies),
      world_frame_(scene.world_frame),
      wrench_timeout_(wrench_timeout),
      frames_(scene, bodies) {
  const TfFrames frames(scene, tf_prefix);
  const auto addName = [this](const std::string& name, const std::string& frame) {
    if (name != frame) frames_.attach(name, frame, Isometry3d::Identity());
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    addName(frames.of(i), body.name);
    for (const PointDef& point : body.points)
      addName(frames.of(i, point.name), body.name + "/" + point.name);
  }
}

void WrenchIntake::setBodies(const std::vector<Body>& bodies) {
  bodies_ = &bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!bodies[i].fixed) frames_.setPrincipalFrame(i, bodies[i].X_BP);
}

WrenchInput WrenchIntake::take(const std::string& body, const geometry_msgs::WrenchStamped& message,
                               double now) {
  const std::string& frame = message.header.frame_id;
  requireShort("frame", frame);
  static_frames_.lookUp(frame, frames_);
  WrenchDef wrench;
  wrench.body = body;
  wrench.frame = frame;
  wrench.force = fromVector3(message.wrench.force);
  wrench.torque = fromVector3(message.wrench.torque);
  wrench.start = now;
  wrench.duration = heldFor();
  WrenchInput input{"frame " + frame, {}};
  if (frame == world_frame_) {
    input.wrench = resolved(wrench);
    // exactly, where the way through the body frame would leave a lever of rounding
    input.wrench.point = (*bodies_)[input.wrench.body].com_P;
    input.wrench.at_center = true;
    return input;
  }
  requireFixedToBody(wrench);
  wrench.point_frame = frame;
  input.wrench = resolved(wrench);
  return input;
}

WrenchInput WrenchIntake::take(const AppliedWrench& message, const TimeOrigin& origin, double now) {
  requireShort("id", message.id);
  static_frames_.lookUp(message.header.frame_id, frames_);
  static_frames_.lookUp(message.point_frame, frames_);
  WrenchDef wrench;
  wrench.body = message.body;
  wrench.frame = message.header.frame_id;
  wrench.point_frame = message.point_frame;
  wrench.point = fromPoint(message.point);
  wrench.force = fromVector3(message.wrench.force);
  wrench.torque = fromVector3(message.wrench.torque);
  wrench.start = startOfInput("start", message.start, origin, now, kFarthestStart);
  wrench.duration = toSeconds(message.duration);
  requireDuration(wrench.duration, message.id);
  if (wrench.duration == 0) wrench.duration = heldFor();
  return {slotOfId(message.id), resolved(wrench)};
}

std::vector<WrenchInput> WrenchIntake::take(const std::vector<AppliedWrench>& messages,
                                            const TimeOrigin& origin, double now) {
  std::vector<WrenchInput> inputs;
  for (const AppliedWrench& message : messages) {
    withPlace(inputs.size(), [&] { inputs.push_back(take(message, origin, now)); });
  }
  return inputs;
}

PointWrench WrenchIntake::resolved(const WrenchDef& wrench) const {
  const ResolvedWrench resolved = resolveWrench(wrench, *bodies_, frames_);
  if (!resolved.fault.empty()) throw std::invalid_argument(resolved.fault);
  return resolved.wrench;
}

/// Other frames do not say where on the body the wrench acts; unknown ones are left to resolved().
void WrenchIntake::requireFixedToBody(const WrenchDef& wrench) const {
  const FixedFrame* frame = frames_.find(wrench.frame);
  const FixedFrame* body = frames_.find(wrench.body);
  if (!frame || !body || frame->body == body->body) return;
  throw std::invalid_argument("frame '" + wrench.frame + "' must be '" + world_frame_ +
                              "' or fixed to body '" + wrench.body + "'");
}

double WrenchIntake::heldFor() const {
  return wrench_timeout_ > 0 ? wrench_timeout_ : std::numeric_limits<double>::infinity();
}

}  // namespace rigid_body_sim
