#pragma once

#include <string>
#include <variant>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/frames.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/displaced_volume.hpp"
#include "support/reference_bench.hpp"

namespace rigid_body_sim::test {

/// Drag and buoyancy of a body.
inline void addReferenceMedium(const Scene& scene, std::size_t body, Bench& bench) {
  const DragDef& def = scene.bodies[body].drag;
  const Isometry3d X_PB = bench.world.bodies[body].X_BP.inverse();
  MediumDrag::Coefficients drag;
  drag.linear = {def.linear, def.linear_axes};
  drag.quadratic = {def.quadratic, def.quadratic_axes};
  drag.angular = {def.angular, def.angular_axes};
  if (def.center) drag.center_P = X_PB * *def.center;
  drag.R_PD = X_PB.linear();
  const Vector3d wind = scene.medium ? scene.medium->velocity : Vector3d(Vector3d::Zero());
  if (def.any()) bench.reference_laws.push_back(reference::mediumDrag(body, drag, wind));
  if (!scene.bodies[body].buoyancy) return;
  const DisplacedVolume displaced = *displacedVolume(scene.bodies[body].composition);
  bench.reference_laws.push_back(reference::buoyancy(body, scene.medium->density * displaced.volume,
                                                     X_PB * displaced.center_B, bench.world.g_W));
}

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
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) addReferenceMedium(scene, i, bench);
  return bench;
}

}  // namespace rigid_body_sim::test
