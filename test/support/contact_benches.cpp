#include "support/contact_benches.hpp"

#include <string>

#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/run/contact_bound.hpp"

namespace rigid_body_sim::test {

ContactShape ballShape(double radius) {
  ContactShape shape;
  shape.balls.push_back({Vector3d::Zero(), radius});
  return shape;
}

ContactShape cornersOf(const Body& body, const Vector3d& size) {
  ContactShape shape;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    shape.points.push_back(body.X_BP.inverse() * Vector3d(0.5 * signs.cwiseProduct(size)));
  }
  return shape;
}

ContactParameters contactOf(double stiffness, double exponent, double dissipation,
                            double friction) {
  ContactParameters parameters;
  parameters.stiffness = stiffness;
  parameters.exponent = exponent;
  parameters.dissipation = dissipation;
  parameters.friction = friction;
  return parameters;
}

HalfSpace slope(double angle) {
  HalfSpace plane;
  plane.q_WH = rotationExp(Vector3d(0, angle, 0));
  return plane;
}

std::size_t addBall(Bench& bench, double radius, double mass, const BodyFrameMotion& motion,
                    const HalfSpace& plane, const ContactParameters& parameters) {
  const std::string name = "ball" + std::to_string(bench.world.bodies.size());
  const std::size_t ball = bench.add(makeBody(name, massProperties(Sphere{radius}, mass)), motion);
  bench.world.laws.push_back(
      contactWithHalfSpace(bench.world.bodies, ball, ballShape(radius), plane, parameters));
  return ball;
}

void letTouch(Bench& bench, std::size_t a, double radius_a, std::size_t b, double radius_b,
              const ContactParameters& parameters) {
  bench.world.laws.push_back(contactOfBalls(bench.world.bodies, a, ballShape(radius_a), b,
                                            ballShape(radius_b), parameters));
}

std::size_t addBox(Bench& bench, const Vector3d& size, double mass, const BodyFrameMotion& motion,
                   const HalfSpace& plane, const ContactParameters& parameters) {
  const std::string name = "box" + std::to_string(bench.world.bodies.size());
  const std::size_t box = bench.add(makeBody(name, massProperties(Box{size}, mass)), motion);
  const ContactShape corners = cornersOf(bench.world.bodies[box], size);
  bench.world.laws.push_back(
      contactWithHalfSpace(bench.world.bodies, box, corners, plane, parameters));
  return box;
}

BodyFrameMotion motionAt(const Vector3d& x_W, const Vector3d& v_W, const Vector3d& w_W) {
  BodyFrameMotion motion;
  motion.x_W = x_W;
  motion.v_W = v_W;
  motion.w_W = w_W;
  return motion;
}

Bench stackedBalls(double x, double y) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.world.solver.tolerance = 1e-4;
  const ContactParameters c = contactOf(1e4, 1.5, 0.5, 0.3);
  addBall(bench, 0.1, 1, motionAt({0, 0, 0.15}), HalfSpace{}, c);
  addBall(bench, 0.1, 1, motionAt({x, y, 0.4}), HalfSpace{}, c);
  letTouch(bench, 0, 0.1, 1, 0.1, c);
  return bench;
}

Simulation simulationAt(Bench bench, double tolerance, double time_step) {
  bench.initial.contact_bound = contactStepBound(tolerance);
  bench.world.solver.tolerance = tolerance;
  bench.world.solver.tolerance_stated = true;
  return bench.simulation("auto", time_step);
}

}  // namespace rigid_body_sim::test
