#pragma once

#include <random>
#include <vector>

#include "support/contact_benches.hpp"
#include "support/reference_contact.hpp"
#include "support/reference_contact_shapes.hpp"

/// Random bodies that are thrown on a random slope, for the product and for the independent
/// reference.
namespace rigid_body_sim::test {

enum class ThrownKind { kBox, kCapsule, kCoin, kEllipsoid, kBalls };
constexpr ThrownKind kThrownKinds[] = {ThrownKind::kBox, ThrownKind::kCapsule, ThrownKind::kCoin,
                                       ThrownKind::kEllipsoid, ThrownKind::kBalls};

struct Thrown {
  Bench bench;
  contact_reference::Scene reference;
  std::vector<contact_reference::Pose> start;
};

class Thrower {
 public:
  explicit Thrower(unsigned seed) : random_(seed) {}

  Thrown next(ThrownKind kind) {
    thrown_ = Thrown();
    thrown_.bench.world.g_W = {0, 0, -9.80665};
    thrown_.reference.g = thrown_.bench.world.g_W.cast<Real>();
    plane_.q_WH = rotationExp(Vector3d(0.2 * uniform(), 0.2 * uniform(), 0));
    const Eigen::Quaternion<Real> tilt = plane_.q_WH.cast<Real>().normalized();
    ground_ = {Vec::Zero(), tilt.toRotationMatrix().col(2)};
    c_ = contactOf(1e5, uniform() < 0 ? 1 : 1.5, 0.3, 0.45 + 0.35 * uniform());
    c_.breakaway = 1e-4;
    law_ = {Real(c_.stiffness), Real(c_.exponent), Real(c_.dissipation), Real(c_.friction),
            Real(c_.breakaway)};
    if (kind == ThrownKind::kBalls)
      throwBalls();
    else
      throwOne(kind);
    return thrown_;
  }

 private:
  using Real = contact_reference::Real;
  using Vec = contact_reference::Vec;

  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vector3d vector() { return {uniform(), uniform(), uniform()}; }

  std::size_t add(double mass, const Vector3d& moments, const Vector3d& x_W, const Vector3d& v_W) {
    BodyFrameMotion motion = motionAt(x_W, v_W, 6 * vector());
    motion.q_WB = rotationExp(Vector3d(2 * vector()));
    const std::string name = "body" + std::to_string(thrown_.start.size());
    const Body body = makeBody(name, {mass, Vector3d::Zero(), moments.asDiagonal()});
    const Eigen::Quaternion<Real> q = motion.q_WB.cast<Real>().normalized();
    const Vec w = q.toRotationMatrix().transpose() * motion.w_W.cast<Real>();
    thrown_.start.push_back({x_W.cast<Real>(), v_W.cast<Real>(), q, w});
    thrown_.reference.bodies.push_back({Real(mass), moments.cast<Real>()});
    return thrown_.bench.add(body, motion);
  }

  /// Contact with the slope of what is given in body axes.
  void touchSlope(std::size_t body, ContactShape shape) {
    std::vector<Body>& bodies = thrown_.bench.world.bodies;
    const Isometry3d X_PB = bodies[body].X_BP.inverse();
    for (Vector3d& point : shape.points) point = X_PB * point;
    for (ContactShape::Ball& ball : shape.balls) ball.center_P = X_PB * ball.center_P;
    for (ContactShape::Ellipsoid& e : shape.ellipsoids) e.q_PE = Quaterniond(X_PB.linear());
    for (ContactShape::Rim& rim : shape.rims) {
      rim.center_P = X_PB * rim.center_P;
      rim.axis_P = X_PB.linear() * rim.axis_P;
    }
    thrown_.bench.world.laws.push_back(contactWithHalfSpace(bodies, body, shape, plane_, c_));
  }

  void throwOne(ThrownKind kind) {
    const std::size_t body = add(1.5, {0.012, 0.017, 0.022}, {0, 0, 0.45},
                                 Vector3d(1.5 * uniform(), 1.5 * uniform(), -1));
    ContactShape shape;
    if (kind == ThrownKind::kBox) addCorners(body, {0.15, 0.1, 0.05}, shape);
    if (kind == ThrownKind::kCapsule) addCaps(body, 0.07, 0.1, shape);
    if (kind == ThrownKind::kCoin) addRims(body, 0.12, 0.01, shape);
    if (kind == ThrownKind::kEllipsoid) addEllipsoid(body, {0.15, 0.1, 0.08}, shape);
    touchSlope(body, shape);
  }

  const contact_reference::Rigid& rigid(std::size_t body) { return thrown_.reference.bodies[body]; }
  void refer(contact_reference::Element element) {
    thrown_.reference.elements.push_back(std::move(element));
  }

  void addCorners(std::size_t body, const Vector3d& half, ContactShape& shape) {
    for (double x : {-1, 1})
      for (double y : {-1, 1})
        for (double z : {-1, 1}) {
          const Vector3d r(x * half.x(), y * half.y(), z * half.z());
          shape.points.push_back(r);
          refer(contact_reference::corner(body, rigid(body), r.cast<Real>(), ground_, law_));
        }
  }

  void addCaps(std::size_t body, double radius, double z, ContactShape& shape) {
    for (double side : {-z, z}) {
      shape.balls.push_back({{0, 0, side}, radius});
      refer(contact_reference::ball(body, rigid(body), {0, 0, Real(side)}, Real(radius), ground_,
                                    law_));
    }
  }

  void addRims(std::size_t body, double radius, double z, ContactShape& shape) {
    for (double side : {-z, z}) {
      shape.rims.push_back({{0, 0, side}, {0, 0, 1}, radius});
      refer(contact_reference::rim(body, rigid(body), Real(side), Real(radius), ground_, law_));
    }
  }

  void addEllipsoid(std::size_t body, const Vector3d& semi_axes, ContactShape& shape) {
    shape.ellipsoids.push_back({Vector3d::Zero(), Quaterniond::Identity(), semi_axes});
    refer(contact_reference::ellipsoid(body, rigid(body), semi_axes.cast<Real>(), ground_, law_));
  }

  /// Two balls that meet above the slope or on it.
  void throwBalls() {
    const double radii[] = {0.1, 0.13};
    const Vector3d apart(0.12 + 0.05 * uniform(), 0.03 * uniform(), 0.14 + 0.03 * uniform());
    for (double side : {-1.0, 1.0}) {
      const double radius = radii[side > 0], mass = side > 0 ? 2 : 0.8;
      const Vector3d drift(0.3 * uniform(), 0.3 * uniform(), 0.2 * uniform());
      const std::size_t body =
          add(mass, Vector3d::Constant(0.4 * mass * radius * radius),
              Vector3d(0, 0, 0.4) + side * apart, drift - side * apart.normalized());
      ContactShape shape;
      shape.balls.push_back({Vector3d::Zero(), radius});
      refer(contact_reference::ball(body, rigid(body), Vec::Zero(), Real(radius), ground_, law_));
      touchSlope(body, shape);
    }
    letTouch(thrown_.bench, 0, radii[0], 1, radii[1], c_);
    refer(contact_reference::balls(0, rigid(0), Real(radii[0]), 1, rigid(1), Real(radii[1]), law_));
  }

  std::mt19937 random_;
  HalfSpace plane_;
  ContactParameters c_;
  contact_reference::Ground ground_;
  contact_reference::Law law_{};
  Thrown thrown_;
};

}  // namespace rigid_body_sim::test
