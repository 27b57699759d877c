#include "support/many_bodies.hpp"

#include "support/random_bodies.hpp"

namespace rigid_body_sim::test {

Bench thrownBodies(std::size_t count, unsigned seed) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  Draw draw(seed);
  for (std::size_t i = 0; i < count; ++i) {
    Body body = draw.box(0.5);
    if (i % 5 == 4) {
      const Vector3d moments[]{{1, 1, 1}, {1, 1, 1.5}, {0.5, 1, 1}};
      body = principalBody("", 1, moments[i / 5 % 3]);
    }
    body.name = "body" + std::to_string(i);
    bench.initial.bodies.push_back(draw.state(body, 5));
    bench.world.bodies.push_back(body);
  }
  return bench;
}

Bench restingBodies(std::size_t count, double zero) {
  Bench bench = thrownBodies(count);
  bench.world.g_W.setZero();
  for (BodyState& s : bench.initial.bodies) {
    s.q_WP = Quaterniond(1, zero, zero, zero);
    s.p_W = s.L_W = s.L_P = s.x_low_W = Vector3d::Constant(zero);
  }
  return bench;
}

}  // namespace rigid_body_sim::test
