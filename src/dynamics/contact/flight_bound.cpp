#include "dynamics/contact/flight_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigid_body_sim {
namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

}  // namespace

double firstRoot(double gap, double speed, double acceleration) {
  if (!(gap >= 0) || !std::isfinite(acceleration)) return 0;
  // without cancellation
  const double root = std::sqrt(speed * speed - 2 * acceleration * gap);
  if (speed < 0) return 2 * gap / (root - speed);
  return acceleration < 0 ? (speed + root) / -acceleration : kNoEnd;
}

PlaneFlight::PlaneFlight(const Body& body, const BodyState& state, const HalfSpace& plane,
                         const MotionBound& bound)
    : horizon_(kNoEnd) {
  const Vector3d n_W = rotate(plane.q_WH, Vector3d(Vector3d::UnitZ()));
  height_ = n_W.dot(state.x_W - plane.origin_W);
  low_ = n_W.dot(state.x_low_W);
  speed_ = n_W.dot(state.p_W) / body.mass;
  acceleration_ = std::min(n_W.dot(bound.a_W), 0.0) - bound.a_off;
  m_P_ = -rotateBack(state.q_WP, n_W);
  m_dot_P_ = m_P_.cross(angularVelocity(body.inv_I, state.L_P));
  turning_ = turningBound(body, state, bound.torque, kTurningTime);
  if (bound.torque > 0) horizon_ = kTurningTime;
}

double PlaneFlight::clearFor(const Feature& feature) const {
  const double bend = turning_ * feature.reach() - acceleration_;
  const auto gap = [&](double tau) {
    const double bottom = support(feature, m_P_ + tau * m_dot_P_);
    return (height_ - bottom) + low_ + tau * (speed_ - 0.5 * bend * tau);
  };
  const double now = gap(0);
  if (!(now >= 0)) return 0;
  if (!std::isfinite(bend)) return 0;
  const double closing = std::abs(speed_) + m_dot_P_.norm() * feature.reach();
  return std::min(lastRoot(gap, firstGuess(now, closing, bend)), horizon_);
}

double PlaneFlight::clearFor(double reach) const {
  const double now = height_ - reach + low_;
  if (!(now > reach)) return 0;
  return firstRoot(now, speed_, acceleration_);
}

}  // namespace rigid_body_sim
