#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/medium_drag.hpp>

#include "dynamics/laws/drag_kink.hpp"
#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/medium_load.hpp"
#include "dynamics/laws/mobility.hpp"

namespace rigid_body_sim {
namespace {

/// x_i |x_i|
Vector3d squaresOf(const Vector3d& x) { return x.cwiseProduct(x.cwiseAbs()); }

Vector3d mediumVelocity(const ForceLaw::Bodies& at) {
  return Vector3d(at.own[0], at.own[1], at.own[2]);
}

/// Drag at the velocity u_P, principal axes [N].
Vector3d dragForce(const MediumDrag::Coefficients& c, const Vector3d& u_P) {
  const Vector3d u_D = c.R_PD.transpose() * u_P;
  const Vector3d along_D =
      c.linear.axes.cwiseProduct(u_D) + c.quadratic.axes.cwiseProduct(squaresOf(u_D));
  return -(c.linear.alike + c.quadratic.alike * u_P.norm()) * u_P - c.R_PD * along_D;
}

Vector3d dragTorque(const MediumDrag::Coefficients& c, const Vector3d& w_P) {
  return -c.angular.alike * w_P -
         c.R_PD * c.angular.axes.cwiseProduct(Vector3d(c.R_PD.transpose() * w_P));
}

void checkKey(const char* rule, const MediumDrag::Key& key) {
  requireNotNegative("drag", rule, key.alike);
  for (int i = 0; i < 3; ++i) requireNotNegative("drag", rule, key.axes(i));
}

}  // namespace

MediumDrag::MediumDrag(std::size_t body, const Coefficients& coefficients, const Vector3d& medium_W)
    : body_(body), coefficients_(coefficients), medium_W_(medium_W) {
  checkKey("linear must be >= 0 N s/m", coefficients.linear);
  checkKey("quadratic must be >= 0 N s^2/m^2", coefficients.quadratic);
  checkKey("angular must be >= 0 N m s", coefficients.angular);
  requireFinite("drag", "its center", coefficients.center_P);
  requireFinite("drag", "the velocity of the medium", medium_W);
  require((coefficients.R_PD * coefficients.R_PD.transpose()).isIdentity(1e-6),
          "law 'drag': its axes must be unit and at right angles");
}

std::shared_ptr<const ForceLaw> MediumDrag::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  return std::make_shared<MediumDrag>(index(body_), coefficients_, medium_W_);
}

/// A centre that is the centre of mass stays that.
std::shared_ptr<const ForceLaw> MediumDrag::reframed(std::size_t /*body*/, const Body& before,
                                                     const Body& after) const {
  const Isometry3d X_NP = frameBefore(before, after);
  auto copy = std::make_shared<MediumDrag>(*this);
  Coefficients& c = copy->coefficients_;
  c.center_P = c.center_P == before.com_P ? after.com_P : Vector3d(X_NP * c.center_P);
  c.R_PD = X_NP.linear() * c.R_PD;
  return copy;
}

/// u in principal axes.
Vector3d MediumDrag::throughMedium(const Bodies& at) const {
  const Body& body = *at.bodies[body_];
  const BodyState& s = at.states[body_];
  const Vector3d w_P = angularVelocity(body.inv_I, s.L_P);
  return rotateBack(s.q_WP, Vector3d(s.p_W / body.mass - mediumVelocity(at))) +
         w_P.cross(coefficients_.center_P);
}

void MediumDrag::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const BodyState& s = at.states[body_];
  const Vector3d f_P = dragForce(coefficients_, throughMedium(at));
  Wrench& wrench = wrenches[body_];
  wrench.f_W += rotate(s.q_WP, f_P);
  wrench.tau_P += coefficients_.center_P.cross(f_P) +
                  dragTorque(coefficients_, angularVelocity(at.bodies[body_]->inv_I, s.L_P));
}

double MediumDrag::externalPower(const Bodies& at) const {
  const BodyState& s = at.states[body_];
  const Vector3d u_P = throughMedium(at);
  const Vector3d w_P = angularVelocity(at.bodies[body_]->inv_I, s.L_P);
  const Vector3d point_P = u_P + rotateBack(s.q_WP, mediumVelocity(at));
  return dragForce(coefficients_, u_P).dot(point_P) + dragTorque(coefficients_, w_P).dot(w_P);
}

void MediumDrag::addStiffness(const std::vector<const Body*>& bodies,
                              std::vector<Stiffness>& stiffness) const {
  const Coefficients& c = coefficients_;
  const Body& body = *bodies[body_];
  stiffness[body_].decay +=
      (c.linear.alike + c.linear.axes.maxCoeff()) * mobilityAt(body, c.center_P) +
      (c.angular.alike + c.angular.axes.maxCoeff()) * body.inv_I.maxCoeff();
}

double MediumDrag::rate(const Bodies& at, const std::vector<double>& speeds) const {
  const Coefficients& c = coefficients_;
  if (!c.quadratic.any()) return 0;  // the speeds may then be left out
  const Body& body = *at.bodies[body_];
  const double speed = speeds[body_] + mediumVelocity(at).norm() +
                       angularVelocity(body.inv_I, at.states[body_].L_P).norm() * c.center_P.norm();
  return 2 * (c.quadratic.alike + c.quadratic.axes.maxCoeff()) * speed *
         mobilityAt(body, c.center_P);
}

double MediumDrag::distanceToKink(const Bodies& at, const std::vector<BodyMotion>& motions,
                                  double h, double negligible) const {
  const Coefficients& c = coefficients_;
  const Body& body = *at.bodies[body_];
  const BodyMotion& motion = motions[body_];
  const BodyAcceleration& a = motion.acceleration;
  const Vector3d w_P = angularVelocity(body.inv_I, motion.state.L_P);
  const Vector3d change_P = rotateBack(motion.state.q_WP, Vector3d(a.felt_W + a.g_W)) +
                            a.w_dot_P.cross(c.center_P) + w_P.cross(w_P.cross(c.center_P));
  return distanceToDragKink(throughMedium(at), change_P,
                            c.quadratic.alike * mobilityAt(body, c.center_P), h, negligible);
}

void MediumDrag::setStart(double* own) const {
  for (int i = 0; i < 3; ++i) {
    own[i] = medium_W_[i];
    own[3 + i] = 1;
  }
}

bool MediumDrag::admits(const double* own) const {
  return std::all_of(own + 3, own + 6, [](double sign) { return std::abs(sign) == 1; });
}

void MediumDrag::setGuards(const Bodies& at, double* guards) const {
  const Vector3d u_D = coefficients_.R_PD.transpose() * throughMedium(at);
  const double least = kZeroShare * u_D.norm();
  for (int i = 0; i < 3; ++i)
    guards[i] = coefficients_.quadratic.axes[i] > 0 ? at.own[3 + i] * u_D[i] + least : 1;
}

void MediumDrag::switchMode(std::size_t guard, const Bodies& /*at*/, double* own) const {
  own[3 + guard] = -own[3 + guard];
}

bool MediumDrag::setMedium(const Vector3d& velocity_W, double* own) const {
  for (int i = 0; i < 3; ++i) own[i] = velocity_W[i];
  return true;
}

void MediumDrag::addMedium(const Bodies& at, MediumLoad& load) const {
  const Coefficients& c = coefficients_;
  const auto along = [&c](const Vector3d& axes) -> Matrix3d {
    return c.R_PD * axes.asDiagonal() * c.R_PD.transpose();
  };
  load.velocity_W = mediumVelocity(at);
  load.center_P = c.center_P;
  load.linear = c.linear.alike;
  if (!c.linear.axes.isZero(0)) load.linear_P = along(c.linear.axes);
  load.quadratic = c.quadratic.alike;
  load.quadratic_axes = c.quadratic.axes;
  load.R_PD = c.R_PD;
  load.angular_P = along(c.angular.axes) + c.angular.alike * Matrix3d::Identity();
}

}  // namespace rigid_body_sim
