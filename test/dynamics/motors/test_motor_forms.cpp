#include <cmath>

#include <gtest/gtest.h>

#include "support/motor_benches.hpp"

/// Motors against what is known in closed form.
namespace rigid_body_sim {
namespace {

using namespace test;

constexpr double kPi = 3.14159265358979323846;

reference::MotorBody plainBody(const Vector3d& I, std::vector<Actuator> actuators) {
  return {{2, Vector3d::Zero(), I.asDiagonal()}, std::move(actuators), Vector3d::Zero()};
}

BodyFrameMotion turningOnly(const Vector3d& w) { return tumbling(Vector3d::Zero(), w); }

BodyFrameMotion motionAfter(const Bench& bench, const State& state) {
  return toBodyFrameMotion(bench.world.bodies[0], state.bodies[0]);
}

}  // namespace

// ω = −u t/(I − J) from rest
TEST(Motors, WheelTurnsABodyAtRestBackwards) {
  Bench bench = benchOf(plainBody({3, 4, 5}, {named("wheel", wheelAlong({0, 1, 0}, 0.5))}),
                        BodyFrameMotion());
  bench.world.commands = {commandOf(0, 0.7, 0)};
  const State end = bench.run("auto", 4, 3);
  const double w = -0.7 * 4 / 3.5, angle = w * 4 / 2;
  EXPECT_NEAR(motionAfter(bench, end).w_W.y(), w, 1e-15);
  EXPECT_LE(
      angleBetween(motionAfter(bench, end).q_WB, rotationExp<double>(angle * Vector3d::UnitY())),
      1e-15);
  EXPECT_EQ(end.bodies[0].L_W, Vector3d::Zero());
}

// Four rotors from standstill, level: z = (4ku²/m)(t²/2 − 2(Tt − T²(1−ε)) + Tt/2 − T²(1−ε²)/4) −
// gt²/2
TEST(Motors, QuadrotorClimbsAsItsLagSays) {
  Bench bench = benchOf(quadrotor(), BodyFrameMotion());
  const double u = 700, T = 0.03, t = 0.5;
  for (std::size_t k = 0; k < 4; ++k) bench.world.commands.push_back(commandOf(k, u, 0));
  const State end = bench.run("auto", t, 50);
  const double e = std::exp(-t / T);
  const double lift =
      t * t / 2 - 2 * (T * t - T * T * (1 - e)) + T * t / 2 - T * T * (1 - e * e) / 4;
  const double z = 4 * 8.5e-6 * u * u / 1.2 * lift - 9.81 * t * t / 2;
  EXPECT_NEAR(motionAfter(bench, end).x_W.z(), z, 1e-15);
  EXPECT_LE(motionAfter(bench, end).w_W.norm(), 1e-15);
}

// I₃ ω = −J ΔΩ − κ ∫ Ω|Ω| dt, through the speed zero
TEST(Motors, RotorReversesThroughStandstill) {
  Rotor rotor = rotorAt(Vector3d::Zero(), 1, 1e-3);
  const double speed = 300, u = -400, T = 0.2, t = 1;
  rotor.time_constant = T;
  rotor.speed = speed;
  rotor.drag_torque = 1.4e-6;
  Bench bench = benchOf(plainBody({0.3, 0.4, 0.5}, {named("rotor", rotor)}), BodyFrameMotion());
  bench.world.commands = {commandOf(0, u, 0)};
  const double delta = speed - u, reversal = T * std::log(1 - speed / u);
  const auto integral = [&](double at) {  // of (u + δε)²
    const double e = std::exp(-at / T);
    return u * u * at + 2 * u * delta * T * (1 - e) + delta * delta * T / 2 * (1 - e * e);
  };
  const double square = integral(reversal) - (integral(t) - integral(reversal));
  const double change = delta * std::exp(-t / T) + u - speed;
  const double w = (-1e-3 * change - 1.4e-6 * square) / 0.5;
  for (int steps : {1, 7, 100})
    EXPECT_NEAR(motionAfter(bench, bench.run("auto", t, steps)).w_W.z(), w,
                1e-14 * std::abs(w) * 10)
        << steps;
}

// Symmetric body, wheel on its axis: R = exp(t L̂/I_t) R₀ exp(Λ ê₃),
//   Λ = ∫ (L₃ − h) dt/I_r3 − L₃ t/I_t
TEST(Motors, WheelOnTheAxisOfASymmetricBody) {
  const double J = 0.4, speed = 12, u = 0.9, t = 10, I_t = 2, I_3 = 3;
  Bench bench =
      benchOf(plainBody({I_t, I_t, I_3}, {named("wheel", wheelAlong({0, 0, 1}, J, speed))}),
              turningOnly({0.3, -0.2, 0.5}));
  bench.world.commands = {commandOf(0, u, 0)};
  const double h = J * (speed + 0.5), L_3 = (I_3 - J) * 0.5 + h;
  const Vector3d L(I_t * 0.3, I_t * -0.2, L_3);
  const double angle = ((L_3 - h) * t - u * t * t / 2) / (I_3 - J) - L_3 * t / I_t;
  const Quaterniond exact =
      product(rotationExp<double>(L * (t / I_t)), rotationExp<double>(angle * Vector3d::UnitZ()));
  const State end = bench.run("auto", t, 10);
  EXPECT_LE(angleBetween(motionAfter(bench, end).q_WB, exact), 1e-13);  // over 50 rad
  EXPECT_LE((end.bodies[0].L_W - L).norm(), 1e-15 * L.norm());
}

// Constant H (Volterra): L_W keeps its bits, ½ ω·I_r ω its value.
TEST(Motors, GyrostatKeepsEnergyAndMomentum) {
  const reference::MotorBody gyrostat = plainBody(
      {3, 4, 5},
      {named("a", wheelAlong({1, 2, 3}, 0.2, 30)), named("b", wheelAlong({-1, 0, 1}, 0.1, 9))});
  const Bench bench = benchOf(gyrostat, turningOnly({0.5, 1, -0.3}));
  Simulation sim = bench.simulation("auto", 0.1);
  const Vector3d L_W = sim.state().bodies[0].L_W;
  const double energy = kineticEnergy(sim.world().bodies[0], sim.body(0));
  EXPECT_GT((L_W - bench.initial.bodies[0].L_W).norm(), 1);  // what the wheels have
  for (int i = 0; i < 1000; ++i) {
    sim.step();
    ASSERT_EQ(sim.body(0).L_W, L_W);
    ASSERT_NEAR(kineticEnergy(sim.world().bodies[0], sim.body(0)), energy, 2e-13 * energy);
  }
}

// Basilisk, simulation of balanced reaction wheels (avslab.github.io/basilisk): the attitude after
// 1 s, q_xyz/(1 + q_w), as its test has it.
TEST(Motors, MeetsThePublishedCaseOfBasilisk) {
  const double J = 100 / (200 * kPi), rpm = 2 * kPi / 60;
  std::vector<Actuator> wheels{named("x", wheelAlong({1, 0, 0}, J, 500 * rpm), 0.2),
                               named("y", wheelAlong({0, 1, 0}, J, 200 * rpm), 0.2),
                               named("z", wheelAlong({0, 0, 1}, J, -150 * rpm), 0.2)};
  reference::MotorBody hub;
  hub.properties_B = {750, {-0.0002, 0.0001, 0.1}, Vector3d(900, 800, 600).asDiagonal()};
  hub.actuators = wheels;
  Bench bench = benchOf(hub, turningOnly({0.08, 0.01, 0}));
  const double torques[] = {0.2, 0.1, -0.5};
  for (std::size_t k = 0; k < 3; ++k) {
    bench.world.commands.push_back(commandOf(k, torques[k], 0));
    bench.world.commands.push_back(commandOf(k, 0, 0.5));
  }
  Simulation sim = bench.simulation("auto", 0.1);
  EXPECT_EQ(sim.saturations(), 1);
  for (int i = 0; i < 10; ++i) sim.step();
  const Quaterniond q = motionAfter(bench, sim.state()).q_WB;
  const Vector3d sigma = q.vec() / (1 + q.w());
  EXPECT_NEAR(sigma.x(), 1.99853994e-2, 5e-11);
  EXPECT_NEAR(sigma.y(), 2.45647716e-3, 5e-12);
  EXPECT_NEAR(sigma.z(), 8.45356279e-6, 5e-15);
}

}  // namespace rigid_body_sim
