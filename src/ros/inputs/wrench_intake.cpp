#include "ros/inputs/wrench_intake.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// The slot, "id <id>" or "frame <frame_id>", is kept with every wrench that acts or is to come.
std::string slotFault(const WrenchRequest& request) {
  const std::size_t kind = request.slot.find(' ');
  if (kind == std::string::npos) return "";  // none
  const std::size_t bytes = request.slot.size() - kind - 1;
  if (bytes <= kMostTextBytes) return "";
  return request.slot.substr(0, kind) + " must have at most " + std::to_string(kMostTextBytes) +
         " bytes, got " + std::to_string(bytes);
}

std::string durationFault(const WrenchRequest& request) {
  const double duration = request.wrench.duration;
  const bool held = duration == 0 && !request.slot.empty();
  if (duration > 0 || held) return "";
  std::ostringstream fault;
  fault << "duration must be " << (request.slot.empty() ? "> 0 s where id is empty" : ">= 0 s")
        << ", got " << duration;
  return fault.str();
}

/// Fault of a frame that has to say where on the body the wrench acts.
std::string placeFault(const WrenchDef& wrench, const FrameTable& frames,
                       const IntakeRules& rules) {
  const FixedFrame* frame = frames.find(wrench.frame);
  const FixedFrame* body = frames.find(wrench.body);
  const bool unknown = !frame || !body;  // left to resolveWrench
  if (unknown || wrench.frame == rules.world_frame || frame->body == body->body) return "";
  return "frame '" + wrench.frame + "' must be '" + rules.world_frame + "' or fixed to body '" +
         wrench.body + "'";
}

}  // namespace

ResolvedWrench takeWrench(const WrenchRequest& request, const std::vector<Body>& bodies,
                          const FrameTable& frames, const IntakeRules& rules, double now) {
  WrenchDef wrench = request.wrench;
  const bool on_center_of_mass = request.placed_by_frame && wrench.frame == rules.world_frame;
  if (request.placed_by_frame && !on_center_of_mass) wrench.point_frame = wrench.frame;
  wrench.start = std::max(wrench.start, now);
  if (wrench.duration == 0)
    wrench.duration =
        rules.wrench_timeout > 0 ? rules.wrench_timeout : std::numeric_limits<double>::infinity();

  ResolvedWrench resolved;
  resolved.fault = slotFault(request);
  if (resolved.fault.empty()) resolved.fault = durationFault(request);
  if (resolved.fault.empty() && request.placed_by_frame)
    resolved.fault = placeFault(wrench, frames, rules);
  if (!resolved.fault.empty()) return resolved;

  resolved = resolveWrench(wrench, bodies, frames);
  // exactly, where the way through the body frame would leave a lever of rounding
  if (on_center_of_mass) resolved.wrench.point.setZero();
  return resolved;
}

}  // namespace rigid_body_sim
