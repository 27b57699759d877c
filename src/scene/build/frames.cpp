#include <rigid_body_sim/math/isometry.hpp>
#include <rigid_body_sim/scene/frames.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
FrameTable::FrameTable(const Scene& scene, const std::vector<Body>& bodies) {
  add(scene.world_frame, {});
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyDef& def = scene.bodies[i];
    const FixedFrame body = def.fixed ? FixedFrame{kWorld, isometry(def.orientation, def.position)}
                                      : FixedFrame{i, bodies[i].X_BP.inverse()};
    add(def.name, body);
    for (const PointDef& point : def.points)
      add(def.name + "/" + point.name,
          {body.body, body.X_PF * isometry(point.orientation, point.position)});
  }
}

void FrameTable::attach(const std::string& name, const std::string& G, const Isometry3d& X_GF) {
  const FixedFrame parent = frames_.at(G);
  add(name, {parent.body, parent.X_PF * X_GF});
}

const FixedFrame* FrameTable::find(const std::string& name) const {
  const auto frame = frames_.find(name);
  return frame == frames_.end() ? nullptr : &frame->second;
}

std::string FrameTable::names() const { return nameList(order_); }

void FrameTable::add(const std::string& name, const FixedFrame& frame) {
  frames_[name] = frame;
  order_.push_back(name);
}

}  // namespace rigid_body_sim
