#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

/// The shipped scenes with laws do what their first lines say.
namespace rigid_body_sim {
namespace {

const double kTurn = 2 * std::acos(-1.0);

/// Runs a scene to its horizon; returns the simulation at the end.
Simulation runScene(const std::string& name,
                    const std::function<void(const Simulation&)>& look = {}) {
  const Scene scene = loadScene(std::string(RIGID_BODY_SIM_SCENES) + "/" + name);
  const World world = buildWorld(scene);
  Simulation sim(world, initialState(scene, world));
  const auto steps = static_cast<std::int64_t>(std::lround(scene.horizon / scene.time_step));
  while (sim.steps() < steps) {
    sim.step();
    if (look) look(sim);
  }
  return sim;
}

/// The z axis of the body frame of body 0.
Vector3d axisOf(const Simulation& sim) {
  const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  return rotate(m.q_WB, Vector3d(Vector3d::UnitZ()));
}

double tiltOf(const Simulation& sim) {
  const Vector3d axis = axisOf(sim);
  return std::atan2(axis.head<2>().norm(), axis.z());
}

}  // namespace

// auto holds 1e-8; momenta are of some 1 kg m/s and 1 kg m²/s
TEST(SpringPairScene, KeepsTheSumOfItsMomenta) {
  Vector3d p[2], L[2];
  const auto sum = [&](const Simulation& sim, int k) {
    p[k] = L[k] = Vector3d::Zero();
    for (const BodyState& s : sim.state().bodies) {
      p[k] += s.p_W;
      L[k] += s.x_W.cross(s.p_W) + s.L_W;
    }
  };
  const Simulation end = runScene("spring_pair.yaml", [&](const Simulation& sim) {
    if (sim.steps() == 1) sum(sim, 0);
  });
  sum(end, 1);
  EXPECT_LE((p[1] - p[0]).norm(), 1e-13);
  EXPECT_LE((L[1] - L[0]).norm(), 1e-8);
  EXPECT_GT(L[0].norm(), 0.1);
}

TEST(DoublePendulumScene, KeepsItsEnergyAndItsHinges) {
  double stretch = 0;
  const Simulation end = runScene("double_pendulum.yaml", [&](const Simulation& sim) {
    const auto tip = [&](std::size_t body, double z) {
      const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[body], sim.body(body));
      return Vector3d(m.x_W + rotate(m.q_WB, Vector3d(0, 0, z)));
    };
    stretch = std::max({stretch, tip(0, -0.25).norm(), (tip(0, 0.25) - tip(1, -0.25)).norm()});
  });
  EXPECT_NEAR(mechanicalEnergy(end.world(), end.state()), 0, 1e-6);
  EXPECT_LT(stretch, 1e-3);
  EXPECT_GT(stretch, 1e-4);
}

// The angle to the vertical passes through zero twice in 0.606 · 1.022 revolutions: 13 times in
// four.
TEST(SatelliteScene, LibratesAboutTheVertical) {
  double last = 0.3, greatest = 0;
  int crossings = 0;
  runScene("satellite.yaml", [&](const Simulation& sim) {
    const BodyState& s = sim.body(0);
    const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], s);
    const Vector3d up_B = rotateBack(m.q_WB, Vector3d(s.x_W.normalized()));
    const double angle = -std::atan2(up_B.y(), up_B.x());
    crossings += angle * last < 0;
    last = angle;
    greatest = std::max(greatest, std::abs(angle));
  });
  EXPECT_EQ(crossings, 13);
  EXPECT_NEAR(greatest, 0.3, 1e-4);
}

TEST(FeatherAndStoneScene, SinksTheOneAndDropsTheOther) {
  const Simulation end = runScene("feather_and_stone.yaml");
  const BodyState& feather = end.body(0);
  const BodyState& stone = end.body(1);
  EXPECT_NEAR(feather.p_W.z() / 0.002, -1, 1e-6);
  // v = V tanh(g t/V), V = 57.985 m/s
  EXPECT_NEAR(stone.p_W.z() / 1.2, -57.98517 * std::tanh(9.80665 * 3 / 57.98517), 1e-5);
  EXPECT_LT(feather.L_W.norm() / end.world().bodies[0].I(2), 0.1);
  EXPECT_NEAR(stone.L_W.norm() / end.world().bodies[1].I(2), 5, 1e-14);
}

TEST(SleepingTopScene, DoesNotWake) {
  double greatest = 0;
  runScene("sleeping_top.yaml",
           [&](const Simulation& sim) { greatest = std::max(greatest, tiltOf(sim)); });
  EXPECT_LT(greatest, 0.005);
}

// Precession at m g l/(I₃ ω) = 1.634 rad/s is the first term of a series in 4 m g l I₁/(I₃ ω)² =
// 0.24.
TEST(HeavyTopScene, PrecessesAndDoesNotFall) {
  double turned = 0, last = -kTurn / 4, least = 1, greatest = 0;
  runScene("heavy_top.yaml", [&](const Simulation& sim) {
    const Vector3d axis = axisOf(sim);
    const double azimuth = std::atan2(axis.y(), axis.x());
    turned += std::remainder(azimuth - last, kTurn);
    last = azimuth;
    least = std::min(least, tiltOf(sim));
    greatest = std::max(greatest, tiltOf(sim));
  });
  EXPECT_NEAR(turned / 10, 1.634, 0.15);
  // within what lies between samples
  EXPECT_NEAR(least, 0.5, 1e-6);
  // cos of it: the root of (1 − u²) 2 m g l/I₁ = (I₃ ω/I₁)² (cos 0.5 − u)
  EXPECT_NEAR(greatest, 0.5681902213350726, 1e-6);
}

// T = 4 √(I/m g c) K(sin 1)
TEST(PendulumScene, ComesBackAfterItsPeriod) {
  const Scene scene = loadScene(std::string(RIGID_BODY_SIM_SCENES) + "/pendulum.yaml");
  const World world = buildWorld(scene);
  Simulation sim(world, initialState(scene, world));
  constexpr double kPeriod = 2.1771551092392154;
  EXPECT_LT(sim.body(0).x_W.norm(), 1e-16);
  while (sim.time() + scene.time_step < kPeriod) sim.step();
  const BodyState back = sim.sample(kPeriod).bodies[0];
  EXPECT_LT(angleBetween(back.q_WP, initialState(scene, world).bodies[0].q_WP), 1e-13);
  EXPECT_LT(back.L_P.norm(), 1e-12);
}

}  // namespace rigid_body_sim
