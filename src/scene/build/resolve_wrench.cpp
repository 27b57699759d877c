#include <algorithm>
#include <cmath>
#include <sstream>

#include <rigid_body_sim/scene/resolve_wrench.hpp>

#include "dynamics/wrenches/wrench_size.hpp"
#include "scene/build/body_names.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

std::string vectorFault(const char* name, const Vector3d& v) {
  return v.allFinite() ? "" : std::string(name) + " must be finite, got " + listed(v);
}

std::string timeFault(const WrenchDef& wrench) {
  if (std::isfinite(wrench.start) && wrench.start + wrench.duration > wrench.start) return "";
  std::ostringstream fault;
  if (!std::isfinite(wrench.start))
    fault << "start must be a finite number of s, got " << wrench.start;
  else if (!(wrench.duration > 0))
    fault << "duration must be > 0 s, got " << wrench.duration;
  else if (!(wrench.start + wrench.duration > wrench.start))
    fault << "duration must be long enough to count beside start " << wrench.start << " s, got "
          << wrench.duration;
  return fault.str();
}

std::string bodyFault(const std::string& name, const std::vector<Body>& bodies,
                      const FixedFrame* frame) {
  if (frame && frame->body != kWorld && bodies[frame->body].name == name)
    return bodies[frame->body].absent ? "body '" + name + "' is absent, no wrench acts on it" : "";
  const auto body =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  if (body == bodies.end())
    return "unknown body '" + printable(name) + "'" + " (known: " + nameList(namesOf(bodies)) +
           ")" + didYouMean(name, namesOf(bodies));
  return "body '" + name + "' is fixed, no wrench can move it";
}

std::string frameFault(const char* key, const std::string& name, const std::vector<Body>& bodies,
                       const FrameTable& frames, const FixedFrame* frame) {
  if (frame) {
    if (frame->body == kWorld || !bodies[frame->body].absent) return "";
    return std::string(key) + " '" + name + "' is fixed to body '" + bodies[frame->body].name +
           "', which is absent";
  }
  return std::string("unknown ") + key + " '" + printable(name) + "'" +
         " (known: " + frames.names() + ")" + frames.suggestion(name);
}

std::string finiteFault(const Vector3d& point, const Vector3d& force, const Vector3d& torque) {
  if (point.allFinite() && force.allFinite() && torque.allFinite()) return "";
  std::string fault = vectorFault("point", point);
  if (fault.empty()) fault = vectorFault("force", force);
  return fault.empty() ? vectorFault("torque", torque) : fault;
}

}  // namespace

ResolvedWrench resolveWrench(const WrenchDef& wrench, const std::vector<Body>& bodies,
                             const FrameTable& frames) {
  const std::string& point_frame = wrench.point_frame.empty() ? wrench.body : wrench.point_frame;
  const FixedFrame* const own = frames.find(wrench.body);
  const FixedFrame* const axes_frame = frames.find(wrench.frame);
  const FixedFrame* const place_frame = point_frame == wrench.body ? own : frames.find(point_frame);
  ResolvedWrench resolved;
  std::string& fault = resolved.fault;
  fault = bodyFault(wrench.body, bodies, own);
  if (fault.empty()) fault = frameFault("frame", wrench.frame, bodies, frames, axes_frame);
  if (fault.empty()) fault = frameFault("point_frame", point_frame, bodies, frames, place_frame);
  if (fault.empty()) fault = finiteFault(wrench.point, wrench.force, wrench.torque);
  if (fault.empty()) fault = timeFault(wrench);
  if (!fault.empty()) return resolved;

  const FixedFrame& axes = *axes_frame;
  const FixedFrame& place = *place_frame;
  PointWrench& applied = resolved.wrench;
  applied.body = own->body;
  applied.axes = axes.body;
  applied.force = axes.X_PF.linear() * wrench.force;
  applied.torque = axes.X_PF.linear() * wrench.torque;
  applied.point_frame = place.body;
  applied.point = place.X_PF * wrench.point;
  applied.start = wrench.start;
  applied.end = wrench.start + wrench.duration;
  const double share = (applied.end - applied.start) / wrench.duration;
  if (std::abs(share - 1) > kImpulseRounding) {  // false for an infinite duration
    applied.force /= share;
    applied.torque /= share;
  }
  // what is finite in its own frame may not be so in another
  fault = finiteFault(applied.point, applied.force, applied.torque);
  if (fault.empty()) fault = wrenchSizeFault(applied);
  return resolved;
}

}  // namespace rigid_body_sim
