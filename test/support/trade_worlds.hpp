#pragma once

#include <memory>
#include <optional>

#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/random_bodies.hpp"
#include "support/reference_bench.hpp"

/// Worlds to measure trades on, and their motion by the independent reference.
namespace rigid_body_sim::test {

struct SpringWorld {
  Bench bench;
  Spring::End from, to;  ///< from body 0 to the world or to body 1
  Spring::Constants spring;
  bool sprung = false;
};

/// One or two boxes of random edges, attitude and spin under gravity, by turns with a wrench fixed
/// in the world, one fixed in the body, a spring to the world, damped or not, and one between them.
inline SpringWorld randomWorld(unsigned seed) {
  Draw draw(seed);
  SpringWorld world;
  Bench& bench = world.bench;
  bench.world.g_W = {0, 0, -9.81};
  const unsigned kind = seed % 4;
  for (unsigned i = 0; i < (kind == 3 ? 2U : 1U); ++i) {
    const Body drawn = draw.box(0.5);
    const Body body = principalBody("box", drawn.mass, drawn.I);
    bench.world.bodies.push_back(body);
    bench.initial.bodies.push_back(draw.state(body, draw.uniform(0.5, 4)));
  }
  if (kind < 2) {
    PointWrench push;
    push.axes = kind == 0 ? kWorld : 0;
    push.force = draw.vector(1);
    push.point = draw.vector(0.2);
    push.start = draw.uniform(0, 0.5);
    push.end = push.start + 1;
    bench.world.wrenches.push_back(push);
    return world;
  }
  world.sprung = true;
  world.from = {0, draw.vector(0.2)};
  world.to = kind == 3 ? Spring::End{1, draw.vector(0.1)} : Spring::End{kWorld, {0, 0, 4}};
  world.spring = {draw.uniform(5, 40), seed % 8 == 6 ? 0.2 : 0.0, 0.5};
  bench.world.laws = {std::make_shared<Spring>(world.from, world.to, world.spring)};
  return world;
}

/// The motions after a duration; the law of the spring is written anew.
inline reference::Motions referenceRun(const SpringWorld& world, double duration) {
  using reference::Real;
  using reference::Vector;
  if (!world.sprung) return referenceRun(world.bench, duration);
  reference::Motions motions;
  const std::vector<Body>& bodies = world.bench.world.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    motions.push_back(reference::toMotion(bodies[i], world.bench.initial.bodies[i]));
  const auto loads = [&](Real, const reference::Motions& m) {
    reference::Loads sum(m.size());
    for (std::size_t i = 0; i < m.size(); ++i)
      sum[i].f_W = Real(bodies[i].mass) * world.bench.world.g_W.cast<Real>();
    Vector arm[2], place[2], speed[2];
    const Spring::End* ends[2] = {&world.from, &world.to};
    for (int e = 0; e < 2; ++e) {
      const Vector point = ends[e]->point.cast<Real>();
      arm[e].setZero();
      place[e] = point;
      speed[e].setZero();
      if (ends[e]->body == kWorld) continue;
      const reference::Motion& body = m[ends[e]->body];
      arm[e] = body.R() * point;
      place[e] = body.x + arm[e];
      speed[e] = body.v + (body.R() * body.w).cross(arm[e]);
    }
    const Vector d = place[1] - place[0];
    const Vector along = d / d.norm();
    const Real tension =
        Real(world.spring.stiffness) * (d.norm() - Real(world.spring.rest_length)) +
        Real(world.spring.damping) * along.dot(speed[1] - speed[0]);
    for (int e = 0; e < 2; ++e) {
      if (ends[e]->body == kWorld) continue;
      const Vector pull = (e == 0 ? tension : -tension) * along;
      sum[ends[e]->body].f_W += pull;
      sum[ends[e]->body].tau_W += arm[e].cross(pull);
    }
    return sum;
  };
  return reference::advance(bodies, loads, motions, 0, static_cast<Real>(duration), 0.05L, 1e-16L);
}

}  // namespace rigid_body_sim::test
