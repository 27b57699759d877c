#pragma once

#include <string>
#include <variant>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/frames.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "support/reference_bench.hpp"

namespace rigid_body_sim::test {

/// The world of a scene file, with the laws written anew for the reference. Without fixed bodies.
inline Bench sceneBench(const std::string& file) {
  const Scene scene = loadScene(file);
  Bench bench;
  bench.world = buildWorld(scene);
  bench.initial = initialState(scene, bench.world);
  const FrameTable frames(scene, bench.world.bodies);
  const auto endOf = [&](const SpringEndDef& end) {
    if (end.body.empty()) return Spring::End{kWorld, end.point};
    const FixedFrame& frame = *frames.find(end.body);
    return Spring::End{frame.body, frame.X_PF * end.point};
  };
  for (const ForceDef& force : scene.forces) {
    if (const auto* spring = std::get_if<SpringDef>(&force.law)) {
      bench.reference_laws.push_back(
          reference::spring(endOf(spring->from), endOf(spring->to),
                            {spring->stiffness, spring->damping, spring->rest_length}));
    } else {
      const auto& gravity = std::get<CentralGravityDef>(force.law);
      for (std::size_t i = 0; i < bench.world.bodies.size(); ++i)
        bench.reference_laws.push_back(
            reference::centralGravity(i, gravity.center, gravity.mu, gravity.gradient));
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].drag.any())
      bench.reference_laws.push_back(reference::drag(i, scene.bodies[i].drag));
  return bench;
}

}  // namespace rigid_body_sim::test
