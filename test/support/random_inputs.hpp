#pragma once

#include <random>
#include <string>
#include <vector>

#include "support/changed_mass.hpp"
#include "support/motor_benches.hpp"

namespace rigid_body_sim::test {

/// What comes in before a step: a function of the step alone, so that every run receives the same.
class RandomInputs {
 public:
  /// Resets with odd seeds only.
  explicit RandomInputs(unsigned seed) : seed_(seed) {}
  bool resets() const { return seed_ % 2 == 1; }

  void apply(Simulation& sim) {
    std::mt19937 random(seed_ + 1000 * static_cast<unsigned>(sim.steps()));
    const auto below = [&random](std::size_t count) { return random() % count; };
    if (below(3) != 0) return;
    const std::size_t body = below(sim.world().bodies.size());
    switch (below(9)) {
      case 0:
        return sim.clearWrenches(body, slot(below(3)));
      case 1:
        if (resets() && below(6) == 0) sim.reset(false);
        return;
      case 2:
        if (below(4) == 0) sim.setState(body, moved(sim.body(body), random));
        return;
      case 8:
        return changeMass(sim, body, random);
      case 3:
      case 4:
        return command(sim, body, random);
      default:
        sim.applyWrench(slot(below(3)), wrench(sim, body, random));
    }
  }

 private:
  static void changeMass(Simulation& sim, std::size_t body, std::mt19937& random) {
    const double mass = uniform(random, 0.1, 1);
    if (random() % 3 != 0 || sim.world().bodies[body].pivoted) return;
    sim.setMassProperties(body, loaded(sim.world().bodies[body], mass, vector(random, 0.05), 0.2));
  }

  static std::string slot(std::size_t k) { return k == 0 ? "" : "slot " + std::to_string(k); }

  static double uniform(std::mt19937& random, double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  }

  static Vector3d vector(std::mt19937& random, double most) {
    const double x = uniform(random, -most, most), y = uniform(random, -most, most);
    return {x, y, uniform(random, -most, most)};
  }

  static BodyState moved(BodyState state, std::mt19937& random) {
    state.p_W += vector(random, 0.5);
    state.x_W.z() += 0.2;
    return state;
  }

  static PointWrench wrench(const Simulation& sim, std::size_t body, std::mt19937& random) {
    PointWrench wrench;
    wrench.body = body;
    const std::size_t other = random() % sim.world().bodies.size();
    wrench.axes = std::vector<std::size_t>{kWorld, body, other}[random() % 3];
    wrench.point_frame = std::vector<std::size_t>{kWorld, kOwnBody, body}[random() % 3];
    wrench.force = vector(random, 1);
    wrench.torque = vector(random, 0.02);
    wrench.point = vector(random, 0.1);
    wrench.start = sim.time() + uniform(random, -0.02, 0.2);
    wrench.end = wrench.start + uniform(random, 0.02, 0.4);
    return wrench;
  }

  static void command(Simulation& sim, std::size_t body, std::mt19937& random) {
    const std::size_t count = sim.world().bodies[body].actuators.size();
    if (count == 0) return;
    ActuatorCommand command = commandOf(random() % count, uniform(random, -2, 2),
                                        sim.time() + uniform(random, -0.05, 0.2));
    command.body = body;
    command.end = command.start + uniform(random, 0.05, 0.5);
    sim.command(command);
  }

  unsigned seed_;
};

}  // namespace rigid_body_sim::test
