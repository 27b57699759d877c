#include <cmath>

#include <rigid_body_sim/dynamics/acceleration.hpp>

namespace rigid_body_sim {
namespace {

/// ω' × r + ω × (ω × r), principal axes.
Vector3d turningOf(const Body& body, const BodyMotion& motion, const Vector3d& r_P) {
  const Vector3d w_P = angularVelocity(body.inv_I, motion.state.L_P);
  return motion.acceleration.w_dot_P.cross(r_P) + w_P.cross(w_P.cross(r_P));
}

/// g(x_c) − g(x_c + arm) of a centre at −r from x_c. With q = (|r + arm|² − |r|²)/|r|²:
///   mu/|r|³ (arm + ((1 + q)^(−3/2) − 1) (r + arm))
Vector3d tide(double mu, const Vector3d& r_W, const Vector3d& arm_W) {
  const double r = r_W.norm();
  const double q = arm_W.dot(arm_W + 2 * r_W) / (r * r);
  const double less = std::expm1(-1.5 * std::log1p(q));
  return mu / (r * r * r) * (arm_W + less * (r_W + arm_W));
}

Vector3d gravity(double mu, const Vector3d& r_W) {
  const double r = r_W.norm();
  return -mu / (r * r * r) * r_W;
}

}  // namespace

Vector3d accelerationOf(const Body& body, const BodyMotion& motion, const Vector3d& point_P) {
  return motion.acceleration.felt_W + motion.acceleration.g_W +
         rotate(motion.state.q_WP, turningOf(body, motion, point_P));
}

Vector3d specificForceOf(const Body& body, const BodyMotion& motion, const Vector3d& point_P) {
  const BodyState& state = motion.state;
  Vector3d felt_W = motion.acceleration.felt_W;
  for (const GravityCenter& of : motion.acceleration.centers) {
    const Vector3d r_W = (state.x_W - of.center_W) + state.x_low_W;
    const Vector3d arm_W = rotate(state.q_WP, point_P);
    // a fixed body may have its centre of mass anywhere, even where gravity is infinite
    const bool is_held = body.fixed || body.pivoted;
    felt_W += is_held ? Vector3d(-gravity(of.mu, r_W + arm_W)) : tide(of.mu, r_W, arm_W);
  }
  return rotateBack(state.q_WP, felt_W) + turningOf(body, motion, point_P);
}

Vector3d pivotForceOf(const Body& body, const BodyMotion& motion) {
  if (!body.pivoted) return Vector3d::Zero();
  return body.mass * accelerationOf(body, motion, body.com_P) - motion.acceleration.on_pivoted_W;
}

}  // namespace rigid_body_sim
