#pragma once

#include <memory>
#include <string>

#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/random_bodies.hpp"
#include "support/worlds.hpp"

/// Worlds to measure trades on.
namespace rigid_body_sim::test {

/// A box of random edges, attitude and spin under gravity, by turns with a wrench fixed in the
/// world, one fixed in the body, a spring to the world, and a spring between two boxes.
inline Bench randomBench(unsigned seed) {
  Draw draw(seed);
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  const auto add = [&] {
    const Body body = draw.box(0.5);
    bench.world.bodies.push_back(body);
    bench.initial.bodies.push_back(draw.state(body, draw.uniform(0.5, 4)));
  };
  add();
  const double stiffness = draw.uniform(5, 40);
  const unsigned kind = seed % 4;
  if (kind < 2) {
    PointWrench push;
    push.axes = kind == 0 ? kWorld : 0;
    push.force = draw.vector(1);
    push.point = draw.vector(0.2);
    push.start = draw.uniform(0, 0.5);
    push.end = push.start + 1;
    bench.world.wrenches.push_back(push);
  } else {
    Spring::End to{kWorld, Vector3d(0, 0, 2)};
    if (kind == 3) {
      add();
      to = {1, draw.vector(0.1)};
    }
    const Spring::Constants constants{stiffness, seed % 8 == 6 ? 0.2 : 0.0, 0.5};
    bench.world.laws.push_back(
        std::make_shared<Spring>(Spring::End{0, draw.vector(0.2)}, to, constants));
  }
  return bench;
}

}  // namespace rigid_body_sim::test
