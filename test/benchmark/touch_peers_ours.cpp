#include <cmath>

#include "benchmark/touch_peers.hpp"
#include "support/contact_benches.hpp"
#include "tools/trade/cpu_time.hpp"

// Ours in steps of 10 ms, over stiffnesses of the ground: what is left is how far a ground that
// yields is from a rigid one. At a tolerance of 1e-6, and cheaper, at 1e-3 and bristles that yield
// ten times as far. A box that lands: over tolerances, at one stiffness.

namespace rigid_body_sim::touch_peers {
namespace {

Vector3d vector(const Array3& v) { return {v[0], v[1], v[2]}; }

struct OurSetting {
  double stiffness, tolerance, breakaway;
};

TouchRun ourRun(const TouchCase& c, const OurSetting& set, std::string setting) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -kGravity};
  BodyFrameMotion motion = test::motionAt(vector(c.x_W), vector(c.v_W), vector(c.w_W));
  motion.q_WB = rotationExp(vector(c.rotation));
  const double dissipation = c.restitution < 1 ? 0.3 : 0;
  ContactParameters parameters = test::contactOf(set.stiffness, 1.5, dissipation, c.friction);
  parameters.breakaway = set.breakaway;
  if (c.radius > 0)
    test::addBall(bench, c.radius, 1, motion, test::slope(0), parameters);
  else
    test::addBox(bench, vector(c.box), 1, motion, test::slope(0), parameters);
  Simulation simulation = test::simulationAt(bench, set.tolerance, 0.01);
  const double begin = cpuTime();
  while (simulation.time() < c.duration - 1e-9) simulation.step();
  TouchRun run{std::move(setting), cpuTime() - begin, {}};
  const BodyState end = simulation.body(0);
  const Vector3d x = end.x_W + end.x_low_W;
  run.x_W = {x[0], x[1], x[2]};
  return run;
}

/// digits: of the stiffness, or, where that is no matter, of the tolerance.
TouchRun ourTouch(const TouchCase& c, double digits) {
  const auto exponent = std::lround(digits);
  if (c.has_truth)
    return ourRun(c, {std::pow(10, digits), 1e-6, 1e-5}, "stiffness 1e" + std::to_string(exponent));
  return ourRun(c, {1e6, std::pow(10, 2 - digits), 1e-5},
                "tolerance 1e" + std::to_string(2 - exponent));
}

TouchRun ourLooseTouch(const TouchCase& c, double digits) {
  if (!c.has_truth) return ourTouch(c, digits);
  return ourRun(c, {std::pow(10, digits), 1e-3, 1e-4},
                "stiffness 1e" + std::to_string(std::lround(digits)));
}

const TouchRegistration kOursTouch({" ours", {4, 6, 8, 10, 12}, ourTouch});
const TouchRegistration kOursLooseTouch({" ours, loose", {3, 4, 5, 6, 8}, ourLooseTouch});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
