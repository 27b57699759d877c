#include "support/costed_contacts.hpp"

#include <cmath>

#include <rigid_body_sim/mass/shapes.hpp>

namespace rigid_body_sim::test {

Bench underGravity() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  return bench;
}

namespace {

/// The depth [m] at which so many points bear a body of a weight [N].
double depthUnder(double weight, int points, const ContactParameters& c) {
  return std::pow(weight / (points * c.stiffness), 1 / c.exponent);
}

/// A body of a shape that touches a plane.
void addShaped(Bench& bench, const Body& body, const BodyFrameMotion& motion, ContactShape shape_B,
               const HalfSpace& plane, const ContactParameters& c) {
  const std::size_t index = bench.add(body, motion);
  const Isometry3d X_PB = body.X_BP.inverse();
  for (ContactShape::Ball& ball : shape_B.balls) ball.center_P = X_PB * ball.center_P;
  for (ContactShape::Ellipsoid& e : shape_B.ellipsoids) {
    e.center_P = X_PB * e.center_P;
    e.q_PE = Quaterniond(X_PB.linear()) * e.q_PE;
  }
  for (ContactShape::Rim& rim : shape_B.rims) {
    rim.center_P = X_PB * rim.center_P;
    rim.axis_P = X_PB.linear() * rim.axis_P;
  }
  bench.world.laws.push_back(contactWithHalfSpace(bench.world.bodies, index, shape_B, plane, c));
}

Bench ballOnGround(const BodyFrameMotion& motion, const HalfSpace& plane,
                   const ContactParameters& c) {
  Bench bench = underGravity();
  addBall(bench, 0.1, 1, motion, plane, c);
  return bench;
}

/// Of Kane & Levinson, as it rolls, spun the way that it does not like.
Bench costedRattleback() {
  Bench bench = underGravity();
  Matrix3d I;
  I << 2e-4, -2e-5, 0, -2e-5, 16e-4, 0, 0, 0, 17e-4;
  const Vector3d semi_axes(0.2, 0.03, 0.02);
  const ContactParameters c = contactOf(1e6, 1.5, 0.4, 1);
  BodyFrameMotion motion;
  motion.q_WB = Quaterniond(0.99998, 0.0043633, 0.0043633, 0).normalized();
  const Vector3d scaled =
      semi_axes.cwiseProduct(rotateBack(motion.q_WB, Vector3d(Vector3d::UnitZ())));
  motion.x_W.z() = scaled.norm() - depthUnder(9.80665, 1, c);
  motion.w_W = rotate(motion.q_WB, Vector3d(0, 0, -5));
  motion.v_W = motion.w_W.cross(
      rotate(motion.q_WB, Vector3d(semi_axes.cwiseProduct(scaled) / scaled.norm())));
  ContactShape shape;
  shape.ellipsoids = {{Vector3d::Zero(), Quaterniond::Identity(), semi_axes}};
  addShaped(bench, makeBody("rattleback", {1, {0, 0, -0.01}, I}), motion, shape, HalfSpace{}, c);
  return bench;
}

Bench costedTippeTop() {
  constexpr double m = 0.02, R = 0.02, kOffset = 0.3 * R;
  Bench bench = underGravity();
  const Vector3d I = m * R * R * Vector3d(0.374286, 0.374286, 0.4);
  const ContactParameters c = contactOf(1e5, 1.5, 0.4, 0.3);
  BodyFrameMotion motion;
  motion.q_WB = rotationExp(Vector3d(0, 0.1, 0));
  motion.w_W = {0, 0, 155};
  motion.x_W.z() = R - kOffset * std::cos(0.1) + 5e-4;
  ContactShape shape;
  shape.balls = {{{0, 0, kOffset}, R}};
  addShaped(bench, makeBody("top", {m, Vector3d::Zero(), I.asDiagonal()}), motion, shape,
            HalfSpace{}, c);
  return bench;
}

/// Dropped from near the ground, tilted and spun.
Bench costedDisk() {
  constexpr double R = 0.05, kLength = 0.01, m = 0.4, kTilt = 0.5;
  Bench bench = underGravity();
  BodyFrameMotion motion;
  motion.q_WB = rotationExp(Vector3d(0, kTilt, 0));
  motion.w_W = rotate(motion.q_WB, Vector3d(0, 0, 10)) + Vector3d(0, 0, 3);
  motion.x_W.z() = R * std::sin(kTilt) + 0.5 * kLength * std::cos(kTilt) + 0.01;
  ContactShape shape;
  for (const double z : {-0.5 * kLength, 0.5 * kLength})
    shape.rims.push_back({{0, 0, z}, {0, 0, 1}, R});
  addShaped(bench, makeBody("disk", massProperties(Cylinder{R, kLength}, m)), motion, shape,
            HalfSpace{}, contactOf(1e5, 1.5, 1, 0.5));
  return bench;
}

/// They strike one another off the line of their centres, and nothing else acts.
Bench costedBalls() {
  Bench bench;
  const ContactParameters c = contactOf(1e6, 1.5, 0.3, 0.5);
  for (const double side : {-1.0, 1.0}) {
    const BodyFrameMotion motion =
        motionAt({side, 0.03 * side, 0}, {-2 * side, 0, 0}, {0, 3, 5 * side});
    bench.add(makeBody(side < 0 ? "a" : "b", massProperties(Sphere{0.1}, 1)), motion);
  }
  letTouch(bench, 0, 0.1, 1, 0.1, c);
  return bench;
}

/// A ball that slides until it rolls.
CostedContact costedRolling(double breakaway) {
  ContactParameters c = contactOf(1e6, 1.5, 0.3, 0.5);
  c.breakaway = breakaway;
  const BodyFrameMotion pushed = motionAt({0, 0, 0.1 - depthUnder(9.80665, 1, c)}, {1, 0, 0});
  return {"ball rolls", ballOnGround(pushed, HalfSpace{}, c), 10, 1, 2.1e4, 8e-13, 7e-13};
}

}  // namespace

CostedContact stifferRolling() {
  CostedContact rolling = costedRolling(1e-5);
  rolling.name += ", breakaway 1e-5";
  return rolling;
}

std::vector<CostedContact> costedContacts() {
  std::vector<CostedContact> cases;
  const auto add = [&](const char* name, const Bench& bench, double duration, int events,
                       double evaluations, double metre, double radian) {
    cases.push_back({name, bench, duration, events, evaluations, metre, radian});
  };
  const ContactParameters hard = contactOf(1e6, 1.5, 0.3, 0.5);
  const HalfSpace ground, hill = slope(0.3);
  add("ball, four bounces",
      ballOnGround(motionAt({0, 0, 0.7}, {1, 0, 0}, {0, 3, 5}), ground,
                   contactOf(1e6, 1.5, 0.1, 0.5)),
      2, 16, 5.9e3, 5e-11, 4e-10);

  Bench landing = underGravity(), sliding = underGravity();
  BodyFrameMotion thrown = motionAt({0, 0, 0.235}, {1.5, 0.2, -1}, {1, 4, 0.5});
  thrown.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.2));
  addBox(landing, {0.4, 0.3, 0.2}, 5, thrown, ground, hard);
  add("box lands", landing, 0.6, 18, 5.6e3, 2e-10, 6e-10);

  const double sunk = 0.1 - depthUnder(9.80665, 4, hard);
  addBox(sliding, {0.4, 0.3, 0.2}, 1, motionAt({0, 0, sunk}, {1, 0, 0}), ground, hard);
  add("box slides and stops", sliding, 0.6, 4, 5.0e3, 2e-12, 2e-11);

  add("rattleback", costedRattleback(), 2, 61, 4.3e4, 1e-10, 5e-8);
  add("tippe top", costedTippeTop(), 1, 29, 1.8e4, 4e-11, 7e-9);
  add("disk on its rim", costedDisk(), 1, 34, 2.9e4, 6e-11, 4e-9);

  cases.push_back(costedRolling(1e-4));
  const Vector3d up = rotate(hill.q_WH, Vector3d(0, 0, 1));
  add("ball rolls down", ballOnGround(motionAt(0.101 * up), hill, contactOf(1e6, 1.5, 1, 0.5)), 2,
      20, 1.4e4, 5e-11, 1e-9);
  add("two balls", costedBalls(), 2, 4, 2.4e3, 5e-10, 3e-10);
  return cases;
}

}  // namespace rigid_body_sim::test
