#include "ros/mouse/mouse.hpp"

#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/math/isometry.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// No other interface of the node uses it.
constexpr char kSlot[] = "mouse";

bool isFinite(const PointWrench& pull) {
  return pull.force.allFinite() && pull.point.cross(pull.force).allFinite();
}

}  // namespace

Mouse::Mouse(const Simulation& simulation, Inputs& inputs, double wrench_timeout,
             std::vector<std::string> tf_frames)
    : simulation_(simulation),
      inputs_(inputs),
      wrench_timeout_(wrench_timeout),
      tf_frames_(std::move(tf_frames)) {
  const std::vector<Body>& bodies = simulation.world().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].fixed) add(i);
  }
}

void Mouse::add(std::size_t body) { moving_bodies_[simulation_.world().bodies[body].name] = body; }

void Mouse::remove(std::size_t body) {
  if (holds_.count(body) > 0) release(body);
  moving_bodies_.erase(simulation_.world().bodies[body].name);
}

std::string Mouse::faultOf(const Feedback& feedback) const {
  const std::string& name = feedback.marker_name;
  const auto found = moving_bodies_.find(name);
  if (found == moving_bodies_.end()) return "unknown handle '" + printable(name) + "'";
  const std::size_t body = found->second;
  if (simulation_.world().bodies[body].absent) return "body '" + name + "' is absent";
  const std::string& frame = tf_frames_.empty() ? name : tf_frames_[body];
  if (feedback.header.frame_id == frame) return "";
  return "feedback on handle '" + name + "' must be in frame '" + frame + "', got '" +
         printable(feedback.header.frame_id) + "'";
}

std::string Mouse::take(const Feedback& feedback) {
  std::string fault = faultOf(feedback);
  if (!fault.empty()) return fault;
  const std::size_t body = moving_bodies_.at(feedback.marker_name);
  if (feedback.event_type == Feedback::MOUSE_DOWN) return press(body, feedback);
  const auto hold = holds_.find(body);
  if (hold == holds_.end() || hold->second.client != feedback.client_id) return "";
  if (feedback.event_type == Feedback::MOUSE_UP) release(body);
  if (feedback.event_type == Feedback::POSE_UPDATE || feedback.event_type == Feedback::KEEP_ALIVE)
    return drag(hold->second, feedback);
  return "";
}

/// Holds the body at the point that was pressed, or at its centre of mass where the viewer does not
/// know the point.
std::string Mouse::press(std::size_t body, const Feedback& feedback) {
  const Isometry3d& X_BP = simulation_.world().bodies[body].X_BP;
  const Vector3d com_B = X_BP * simulation_.world().bodies[body].com_P;
  Hold hold;
  hold.client = feedback.client_id;
  hold.point_B = feedback.mouse_point_valid ? fromPoint(feedback.mouse_point) : com_B;
  hold.spring.body = body;
  hold.spring.point_P = X_BP.inverse() * hold.point_B;
  std::string fault = drag(hold, feedback);
  if (fault.empty()) holds_[body] = std::move(hold);
  return fault;
}

/// The handle has been moved in the body frame B, as B was at the stamp, by its pose in B; so has
/// the goal of the point that is held.
std::string Mouse::drag(Hold& hold, const Feedback& feedback) {
  const std::size_t body = hold.spring.body;
  note(hold);
  MouseSpring spring = hold.spring;
  spring.goal_W =
      hold.poses.at(feedback.header.stamp) * (hold.point_B + fromPoint(feedback.pose.position));
  if (!isFinite(pullOf(spring, simulation_.world().bodies[body], simulation_.body(body),
                       simulation_.world().solver.time_step)))
    return "feedback on handle '" + feedback.marker_name + "' must make a finite pull";
  hold.spring = spring;
  hold.until = wrench_timeout_ > 0 ? simulation_.time() + wrench_timeout_
                                   : std::numeric_limits<double>::infinity();
  return "";
}

std::string Mouse::pull() {
  std::string fault;
  for (auto it = holds_.begin(); it != holds_.end();) {
    const std::string refused = pull(it->second);
    it = refused.empty() ? std::next(it) : holds_.erase(it);
    if (!refused.empty()) fault = refused;
  }
  return fault;
}

std::string Mouse::pull(Hold& hold) {
  const std::size_t body = hold.spring.body;
  const World& world = simulation_.world();
  note(hold);
  if (simulation_.time() >= hold.until) return "";
  PointWrench pull =
      pullOf(hold.spring, world.bodies[body], simulation_.body(body), world.solver.time_step);
  pull.start = simulation_.time();
  pull.end = hold.until;
  try {
    inputs_.apply(WrenchInput{kSlot, pull});
  } catch (const std::invalid_argument& error) {
    return "body '" + world.bodies[body].name + "' is let go: " + error.what();
  }
  return "";
}

void Mouse::follow(const SimulationInput& input) {
  const auto* clear = std::get_if<ClearInput>(&input);
  const bool clears_all = clear && clear->body == ClearInput::kEveryBody && clear->slot.empty();
  const bool begins_anew =
      std::holds_alternative<ResetInput>(input) || std::holds_alternative<LoadInput>(input);
  if (clears_all || begins_anew) return holds_.clear();
  if (clear && clear->slot.empty()) holds_.erase(clear->body);
  if (const auto* presence = std::get_if<PresenceInput>(&input)) holds_.erase(presence->body);
  if (const auto* mass = std::get_if<MassInput>(&input))
    if (const auto hold = holds_.find(mass->body); hold != holds_.end())
      hold->second.spring.point_P =
          simulation_.world().bodies[mass->body].X_BP.inverse() * hold->second.point_B;
}

void Mouse::release(std::size_t body) {
  holds_.erase(body);
  inputs_.apply(ClearInput{body, kSlot});
}

void Mouse::note(Hold& hold) const {
  const std::size_t body = hold.spring.body;
  const BodyFrameMotion motion =
      toBodyFrameMotion(simulation_.world().bodies[body], simulation_.body(body));
  hold.poses.add(inputs_.stamp(), isometry(motion.q_WB, motion.x_W));
}

}  // namespace rigid_body_sim
