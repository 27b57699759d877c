#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

#include "support/motor_benches.hpp"

/// What command changes of motors cost, and what they leave:
///   a quadrotor whose four rotors are commanded 1000 times in 10 s, in one step of 10 s, and in
///   steps of 1 ms that are read
///   a satellite whose wheels are commanded at each of a million steps
namespace rigid_body_sim {
namespace {

/// Of the processor: other programs do not count.
double secondsSince(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
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

/// The same flight by the reference of the tests.
const reference::MotorMotion& exactFlight() {
  static const reference::MotorMotion exact = [] {
    reference::MotorMotion drone(test::quadrotor(), BodyFrameMotion());
    double t = 0;
    for (const ActuatorCommand& command : commandedQuadrotor().world.commands) {
      const reference::Wide wait = reference::Wide(command.start) - reference::Wide(t);
      if (wait > 0) drone.advance(wait, 0.01L);
      t = command.start;
      drone.command(command.actuator, command.value);
    }
    drone.advance(10 - reference::Wide(t), 0.01L);
    return drone;
  }();
  return exact;
}

void flyQuadrotor(const char* integrator, int steps) {
  const test::Bench bench = commandedQuadrotor();
  double best = 1e9, attitude = 0, position = 0;
  for (int repeat = 0; repeat < 7; ++repeat) {
    Simulation sim = bench.simulation(integrator, 10. / steps);
    const auto start = std::clock();
    for (int i = 0; i < steps; ++i) {
      sim.step();
      sim.body(0);
    }
    best = std::min(best, secondsSince(start));
    const BodyFrameMotion end = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
    attitude = reference::attitudeGap(end, exactFlight());
    position = reference::positionGap(sim.body(0), exactFlight());
  }
  std::printf(
      "quadrotor, %-6s in %5d steps: %.2f us a change of its four commands; %.1e rad, %.1e m\n",
      integrator, steps, best * 1e6 / 1000, attitude, position);
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
  const auto start = std::clock();
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
