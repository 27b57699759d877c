#pragma once

#include <vector>

#include "support/contact_benches.hpp"
#include "support/reference_contact.hpp"
#include "support/reference_contact_shapes.hpp"

/// Small scenes with contact, each for the product and for the independent reference.
namespace rigid_body_sim::test {

class ContactTwin {
 public:
  Bench bench;
  contact_reference::Scene reference;
  std::vector<contact_reference::Pose> start;

  ContactTwin() {
    bench.world.g_W = {0, 0, -9.80665};
    reference.g = bench.world.g_W.cast<Real>();
  }

  /// A ball, in flight or on the ground z = 0.
  static ContactTwin ball(double radius, double mass, const BodyFrameMotion& motion,
                          const ContactParameters& parameters) {
    ContactTwin twin;
    twin.add(mass, Vector3d::Constant(0.4 * mass * radius * radius), motion);
    twin.bench.world.laws.push_back(
        contactWithHalfSpace(twin.bench.world.bodies, 0, ballShape(radius), slope(0), parameters));
    twin.refer(contact_reference::ball(0, twin.reference.bodies[0], Vec::Zero(), Real(radius),
                                       ground(), lawOf(parameters)));
    return twin;
  }

  /// A box, by its corners.
  static ContactTwin box(const Vector3d& size, double mass, const BodyFrameMotion& motion,
                         const ContactParameters& parameters) {
    ContactTwin twin;
    const Vector3d squares = size.cwiseAbs2();
    twin.add(mass, mass / 12 * (Vector3d::Constant(squares.sum()) - squares), motion);
    const std::vector<Body>& bodies = twin.bench.world.bodies;
    twin.bench.world.laws.push_back(
        contactWithHalfSpace(bodies, 0, cornersOf(bodies[0], size), slope(0), parameters));
    for (int k = 0; k < 8; ++k) {
      const Vector3d signs(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      const Vec r = (0.5 * signs.cwiseProduct(size)).cast<Real>();
      twin.refer(
          contact_reference::corner(0, twin.reference.bodies[0], r, ground(), lawOf(parameters)));
    }
    return twin;
  }

  /// The motion by the independent reference, at the ends of equal intervals.
  std::vector<State> track(double duration, int intervals) {
    std::vector<State> states;
    for (const auto& poses : reference.track(start, Real(duration), intervals)) {
      states.push_back(bench.initial);
      states.back().t = duration * static_cast<double>(states.size() - 1) / intervals;
      for (std::size_t i = 0; i < poses.size(); ++i)
        states.back().bodies[i] = toBodyState(bench.world.bodies[i], motionOf(poses[i]));
    }
    return states;
  }

 private:
  using Real = contact_reference::Real;
  using Vec = contact_reference::Vec;

  static contact_reference::Ground ground() { return {Vec::Zero(), Vec::UnitZ()}; }

  static contact_reference::Law lawOf(const ContactParameters& c) {
    return {Real(c.stiffness), Real(c.exponent), Real(c.dissipation), Real(c.friction),
            Real(c.breakaway)};
  }

  static BodyFrameMotion motionOf(const contact_reference::Pose& pose) {
    BodyFrameMotion motion;
    motion.x_W = pose.x.cast<double>();
    motion.v_W = pose.v.cast<double>();
    motion.q_WB = pose.q.cast<double>();
    motion.w_W = Vec(pose.R() * pose.w).cast<double>();
    return motion;
  }

  void refer(contact_reference::Element element) {
    reference.elements.push_back(std::move(element));
  }

  /// A body whose frame lies at its centre of mass, along its principal axes.
  void add(double mass, const Vector3d& moments, const BodyFrameMotion& motion) {
    bench.add(makeBody("body", {mass, Vector3d::Zero(), moments.asDiagonal()}), motion);
    const Eigen::Quaternion<Real> q = motion.q_WB.cast<Real>().normalized();
    const Vec w = q.toRotationMatrix().transpose() * motion.w_W.cast<Real>();
    start.push_back({motion.x_W.cast<Real>(), motion.v_W.cast<Real>(), q, w});
    reference.bodies.push_back({Real(mass), moments.cast<Real>()});
  }
};

/// Bounces without spin, losing speed each time.
inline ContactTwin bouncingBall() {
  return ContactTwin::ball(0.1, 1, motionAt({0, 0, 0.3}, {0.2, 0, 0}), contactOf(1e5, 1.5, 0.1, 0));
}

/// Strikes the ground with one corner after another.
inline ContactTwin landingBox() {
  BodyFrameMotion motion = motionAt({0, 0, 0.35}, {0.5, 0.2, -1}, {1, 2, 0.5});
  motion.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.1));
  return ContactTwin::box({0.4, 0.3, 0.2}, 5, motion, contactOf(1e5, 1.5, 0.2, 0.5));
}

/// Slides on a face, slower and slower, and stops.
inline ContactTwin slidingBox() {
  return ContactTwin::box({0.4, 0.3, 0.2}, 5, motionAt({0, 0, 0.1}, {0.3, 0.05, 0}),
                          contactOf(1e5, 1.5, 0.3, 0.5));
}

/// Slides first, and rolls from when it grips.
inline ContactTwin rollingBall() {
  return ContactTwin::ball(0.1, 1, motionAt({0, 0, 0.1}, {1, 0, 0}, {0, 2, 0}),
                           contactOf(1e5, 1.5, 0.3, 0.4));
}

/// Bounces for ever without loss, every time on another corner: chaos.
inline ContactTwin tumblingBox() {
  BodyFrameMotion motion = motionAt({0, 0, 0.5}, {0, 0, 0}, {1, 2, 0.5});
  motion.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.1));
  ContactTwin twin = ContactTwin::box({0.4, 0.3, 0.2}, 5, motion, contactOf(2e4, 1, 0, 0));
  twin.reference.flight_step = 1e-4L;  // what it errs by grows with all else
  return twin;
}

}  // namespace rigid_body_sim::test
