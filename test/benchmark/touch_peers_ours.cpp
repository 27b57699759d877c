#include <cmath>

#include "benchmark/touch_peers.hpp"
#include "support/contact_benches.hpp"
#include "tools/trade/cpu_time.hpp"

// Ours in steps of 10 ms, over stiffnesses of the ground: what is left is how far a ground that
// yields is from a rigid one. At a tolerance of 1e-6, and cheaper, at 1e-3 and bristles that yield
// ten times as far; under a rattleback, as far as the ground itself yields. A box that lands: over
// tolerances, at one stiffness.

namespace rigid_body_sim::touch_peers {
namespace {

Vector3d vector(const Array3& v) { return {v[0], v[1], v[2]}; }

struct OurSetting {
  double stiffness, tolerance, breakaway;
};

/// Released at the depth at which it rests.
void addEllipsoid(test::Bench& bench, const TouchCase& c, BodyFrameMotion motion, double depth,
                  const ContactParameters& parameters) {
  motion.x_W.z() -= depth;
  const Body body =
      makeBody("rattleback", {1, Vector3d::Zero(), Matrix3d(vector(c.inertia).asDiagonal())});
  bench.add(body, motion);
  const Isometry3d X_PB = body.X_BP.inverse();
  ContactShape shape;
  shape.ellipsoids = {{X_PB * Vector3d(0, 0, c.shape_up),
                       Quaterniond(X_PB.linear()) * rotationExp(Vector3d(0, 0, c.shape_turn)),
                       vector(c.semi_axes)}};
  bench.world.laws = {
      contactWithHalfSpace(bench.world.bodies, 0, shape, test::slope(0), parameters)};
}

TouchRun ourRun(const TouchCase& c, const OurSetting& set, std::string setting) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -kGravity};
  BodyFrameMotion motion = test::motionAt(vector(c.x_W), vector(c.v_W), vector(c.w_W));
  motion.q_WB = rotationExp(vector(c.rotation));
  const double dissipation = c.restitution < 1 ? 0.3 : 0;
  ContactParameters parameters = test::contactOf(set.stiffness, 1.5, dissipation, c.friction);
  parameters.breakaway = set.breakaway;
  if (c.isEllipsoid()) {  // it yields as far along the plane as across
    parameters.breakaway = std::pow(kGravity / set.stiffness, 1 / 1.5);
    addEllipsoid(bench, c, motion, parameters.breakaway, parameters);
  } else if (c.radius > 0)
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
  const BodyFrameMotion moved = toBodyFrameMotion(simulation.world().bodies[0], end);
  run.q = {moved.q_WB.x(), moved.q_WB.y(), moved.q_WB.z(), moved.q_WB.w()};
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

const TouchRegistration kOursTouch(
    {" ours", {4, 6, 8, 10, 12}, ourTouch, {6, 7, 8, 9, 10, 11, 12, 13, 14}});
const TouchRegistration kOursLooseTouch(
    {" ours, loose", {3, 4, 5, 6, 8}, ourLooseTouch, {6, 7, 8, 9, 10, 11, 12, 13, 14}});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
