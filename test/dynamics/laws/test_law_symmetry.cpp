#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/law_cases.hpp"
#include "support/method_cases.hpp"

/// Motions in media, on tethers and on pivots in a scene that is turned, moved or mirrored.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::LawCase;
using test::Placement;

struct MotionCase {
  const char* name;
  std::function<Bench(const Placement& scene)> make;
  const char* integrator = "auto";  ///< which solves it; dop853 where it would be stepped
};

const Vector3d kDown{0.5, 1, -9.8};

BodyFrameMotion placedMotion(const BodyFrameMotion& motion, const Placement& scene) {
  BodyFrameMotion placed;
  placed.x_W = scene.point(motion.x_W);
  placed.q_WB = scene.attitude(motion.q_WB);
  placed.v_W = scene.vector(motion.v_W);
  placed.w_W = scene.spin(motion.w_W);
  return placed;
}

/// Two bodies without symmetry, the second of which the law of a case acts on.
Bench underLaw(const LawCase& law, const Placement& scene) {
  Bench bench;
  bench.world.g_W = scene.vector(kDown);
  BodyFrameMotion motion = test::tumbling({1, -0.5, 2}, {1, 2, -1}, Quaterniond(0.6, 0, 0.8, 0));
  bench.add(test::principalBody("first", 1.5, {0.3, 0.4, 0.6}), placedMotion(motion, scene));
  motion.x_W = {1, 0.5, 0.3};
  motion.w_W = {-1, 0.4, 2};
  bench.add(test::principalBody("second", 2, {0.2, 0.5, 0.6}), placedMotion(motion, scene));
  bench.world.laws.push_back(law.make(scene));
  return bench;
}

/// On a pivot, under gravity, a force held in the world at a point of the body, and a wind.
Bench onPivotInWind(const Placement& scene) {
  Bench bench;
  bench.world.g_W = scene.vector(kDown);
  Matrix3d I;
  I << 0.5, 0.02, -0.03, 0.02, 0.7, 0.05, -0.03, 0.05, 0.9;
  const MassProperties mass{2, scene.inBody(Vector3d(0.1, 0.05, -0.2)), scene.inBody(I)};
  BodyFrameMotion motion = test::tumbling({0, 0, 0}, {1, -0.7, 0.4});
  motion.x_W = {1, 2, 3};
  bench.add(makeBody("box", mass, {}, scene.inBody(Vector3d(0.05, -0.1, 0.3))),
            placedMotion(motion, scene));
  const Body& body = bench.world.bodies[0];
  PointWrench push;
  push.force = scene.vector({1, 2, -1});
  push.point = body.X_BP.inverse() * scene.inBody(Vector3d(0.2, 0.1, 0.4));
  bench.world.wrenches = {push};
  return bench;
}

Bench onPivotWithDrag(const Placement& scene) {
  Bench bench = onPivotInWind(scene);
  MediumDrag::Coefficients drag;
  drag.linear.alike = 0.4;
  drag.quadratic.alike = 0.3;
  drag.center_P = bench.world.bodies[0].com_P;
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, scene.vector({3, -1, 2})));
  return bench;
}

std::vector<MotionCase> motionCases() {
  std::vector<MotionCase> cases{{"pivot", onPivotInWind},
                                {"drag_on_a_pivot", onPivotWithDrag, "dop853"}};
  const auto add = [&cases](const std::vector<LawCase>& laws, const char* integrator) {
    for (const LawCase& law : laws)
      cases.push_back(
          {law.name, [law](const Placement& scene) { return underLaw(law, scene); }, integrator});
  };
  add(test::detail::lawsOfMedium(), "auto");
  add(test::detail::tethers(0.8), "dop853");
  return cases;
}

class EveryMotion : public testing::TestWithParam<MotionCase> {};

INSTANTIATE_TEST_SUITE_P(Laws, EveryMotion, testing::ValuesIn(motionCases()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Rounding, within 1 s, of some 10 m and 5 rad.
TEST_P(EveryMotion, IsTheSameInASceneThatIsTurnedMovedOrMirrored) {
  const Bench here = GetParam().make(Placement());
  const State end = here.run(GetParam().integrator, 1, 400);
  for (const Placement& scene : test::everyPlacement()) {
    const Bench there = GetParam().make(scene);
    const State end_there = there.run(GetParam().integrator, 1, 400);
    for (std::size_t i = 0; i < here.world.bodies.size(); ++i) {
      const BodyFrameMotion expected =
          placedMotion(toBodyFrameMotion(here.world.bodies[i], end.bodies[i]), scene);
      const BodyFrameMotion m = toBodyFrameMotion(there.world.bodies[i], end_there.bodies[i]);
      EXPECT_LE((m.x_W - expected.x_W).norm(), 1e-12) << i << scene.mirrored;
      EXPECT_LE(angleBetween(m.q_WB, expected.q_WB), 1e-12) << i << scene.mirrored;
      EXPECT_LE((m.v_W - expected.v_W).norm(), 1e-11) << i << scene.mirrored;
      EXPECT_LE((m.w_W - expected.w_W).norm(), 1e-11) << i << scene.mirrored;
    }
  }
}

// Energies of up to 400 J.
TEST_P(EveryMotion, KeepsTheBalance) {
  Simulation sim = GetParam().make(Placement()).simulation(GetParam().integrator, 0.0025);
  sim.trackBalance();
  while (sim.steps() < 400) sim.step();
  EXPECT_NEAR(sim.balance().energy, 0, 1e-12 * (1 + std::abs(sim.exchanged().energy)));
  EXPECT_NEAR(sim.balance().momentum.norm(), 0, 1e-12 * (1 + sim.exchanged().momentum.norm()));
  EXPECT_NEAR(sim.balance().angular_momentum.norm(), 0,
              1e-12 * (1 + sim.exchanged().angular_momentum.norm()));
}

}  // namespace
}  // namespace rigid_body_sim
