#include <algorithm>
#include <stdexcept>

#include <rigid_body_sim/math/isometry.hpp>
#include <rigid_body_sim/scene/frames.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

FrameTable::FrameTable(const Scene& scene, const std::vector<Body>& bodies) {
  std::size_t points = 0;
  for (const BodyDef& def : scene.bodies) points += def.points.size();
  order_.reserve(1 + bodies.size() + points);
  put(scene.world_frame, {});
  for (std::size_t i = 0; i < bodies.size(); ++i) add(scene.bodies[i], bodies[i], i);
}

void FrameTable::add(const BodyDef& def, const Body& body, std::size_t index) {
  const FixedFrame frame = def.fixed ? FixedFrame{kWorld, isometry(def.orientation, def.position)}
                                     : FixedFrame{index, body.X_BP.inverse()};
  put(def.name, {frame, def.name});
  if (frameOf(def) != def.name) put(frameOf(def), {frame, def.name});
  for (const PointDef& point : def.points) {
    const Isometry3d X_BF = isometry(point.orientation, point.position);
    put(def.name + "/" + point.name, {{frame.body, frame.X_PF * X_BF}, def.name, X_BF});
  }
}

void FrameTable::remove(const std::string& body) {
  const auto isGone = [&](const std::string& name) { return frames_.at(name).body == body; };
  const auto gone = std::stable_partition(order_.begin(), order_.end(),
                                          [&](const std::string& name) { return !isGone(name); });
  for (auto name = gone; name != order_.end(); ++name) frames_.erase(*name);
  order_.erase(gone, order_.end());
}

void FrameTable::attach(const std::string& name, const std::string& G, const Isometry3d& X_GF) {
  const auto entry = frames_.find(G);
  if (entry == frames_.end())
    throw std::invalid_argument("frame '" + name + "': there is no frame '" + G +
                                "' that it could be attached to");
  const Entry& parent = entry->second;
  put(name, {{parent.frame.body, parent.frame.X_PF * X_GF}, parent.body, parent.X_BF * X_GF});
}

void FrameTable::setPrincipalFrame(std::size_t body, const Isometry3d& X_BP) {
  const Isometry3d X_PB = X_BP.inverse();
  for (auto& [name, entry] : frames_)
    if (entry.frame.body == body) entry.frame.X_PF = X_PB * entry.X_BF;
}

const FixedFrame* FrameTable::find(const std::string& name) const {
  const auto entry = frames_.find(name);
  return entry == frames_.end() ? nullptr : &entry->second.frame;
}

std::string FrameTable::names() const { return nameList(order_); }

std::string FrameTable::suggestion(const std::string& name) const {
  return didYouMean(name, order_);
}

void FrameTable::put(const std::string& name, const Entry& entry) {
  if (frames_.insert_or_assign(name, entry).second) order_.push_back(name);
}

}  // namespace rigid_body_sim
