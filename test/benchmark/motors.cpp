#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "support/motor_benches.hpp"

/// What command changes of motors cost, and what they leave:
///   a quadrotor whose four rotors are commanded 1000 times in 10 s, in one step of 10 s, and in
///   steps of 1 ms that are read
///   a satellite whose wheels are commanded at each of a million steps
namespace rigid_body_sim {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

test::Bench commandedQuadrotor() {
  test::Bench bench = test::benchOf(test::quadrotor(), BodyFrameMotion());
  std::mt19937 draw(7);
  std::uniform_real_distribution<double> jitter(0, 1e-3), speed(580, 600);
  for (int n = 0; n < 1000; ++n) {
    const double t = n * 0.01 + jitter(draw);
    const double pair[] = {speed(draw), speed(draw)};  // opposite rotors alike: no tumbling
    for (std::size_t k = 0; k < 4; ++k)
      bench.world.commands.push_back(test::commandOf(k, pair[k % 2], t));
  }
  return bench;
}

void flyQuadrotor(const char* integrator, int steps) {
  const test::Bench bench = commandedQuadrotor();
  double best = 1e9;
  for (int repeat = 0; repeat < 7; ++repeat) {
    Simulation sim = bench.simulation(integrator, 10. / steps);
    const auto start = Clock::now();
    for (int i = 0; i < steps; ++i) {
      sim.step();
      sim.body(0);
    }
    best = std::min(best, secondsSince(start));
  }
  std::printf("quadrotor, %-7s %6d steps: %.2f us a change of its four commands\n", integrator,
              steps, best * 1e6 / 1000);
}

void turnSatellite() {
  reference::MotorBody satellite;
  satellite.properties_B = {10, Vector3d::Zero(), Vector3d(0.4, 0.5, 0.6).asDiagonal()};
  for (int k = 0; k < 3; ++k)
    satellite.actuators.push_back(test::named(std::string(1, static_cast<char>('x' + k)),
                                              test::wheelAlong(Vector3d::Unit(k), 0.01), 0.2));
  Simulation sim = test::benchOf(satellite, test::tumbling({0, 0, 0}, {0.3, -0.2, 0.1}))
                       .simulation("auto", 0.01);
  const Vector3d L_W = sim.body(0).L_W;
  std::mt19937 draw(3);
  std::uniform_real_distribution<double> torque(-0.2, 0.2);
  constexpr int kSteps = 1000000;
  const auto start = Clock::now();
  for (int i = 0; i < kSteps; ++i) {
    sim.command(test::commandOf(static_cast<std::size_t>(i % 3), torque(draw), sim.time()));
    sim.step();
  }
  std::printf("satellite, %d steps with a command each: %.2f us a step, L_W %s\n", kSteps,
              secondsSince(start) * 1e6 / kSteps,
              sim.body(0).L_W == L_W ? "has the same bits" : "HAS CHANGED");
}

}  // namespace
}  // namespace rigid_body_sim

int main() {
  rigid_body_sim::flyQuadrotor("auto", 1);
  rigid_body_sim::flyQuadrotor("auto", 10000);
  rigid_body_sim::flyQuadrotor("rk4", 10000);
  rigid_body_sim::turnSatellite();
}
