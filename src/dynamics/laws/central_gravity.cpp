#include <cmath>

#include <rigid_body_sim/dynamics/central_gravity.hpp>

#include "dynamics/laws/law_rules.hpp"

namespace rigid_body_sim {
namespace {

/// I n of the whole body, principal axes: with what wheels have about their own axes, which I of
/// Body leaves out. Gravity pulls at them, whether they turn or not.
Vector3d wholeInertiaTimes(const Body& body, const Vector3d& n_P) {
  Vector3d product = body.I.cwiseProduct(n_P);
  for (const Actuator& actuator : body.actuators)
    if (const Wheel* wheel = std::get_if<Wheel>(&actuator.kind)) {
      const Vector3d axis_P = rotateBack(body.q_BP, wheel->axis_B);
      product += wheel->inertia * axis_P.dot(n_P) * axis_P;
    }
  return product;
}

}  // namespace

CentralGravity::CentralGravity(std::size_t body, const Vector3d& center_W, double mu, bool gradient)
    : body_(body), gravity_{center_W, mu}, gradient_(gradient) {
  requireFinite("central gravity", "center", center_W);
  requirePositive("central gravity", "mu must be > 0 m^3/s^2", mu);
}

std::shared_ptr<const ForceLaw> CentralGravity::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  return std::make_shared<CentralGravity>(index(body_), gravity_.center_W, gravity_.mu, gradient_);
}

std::shared_ptr<const ForceLaw> CentralGravity::reframed(std::size_t /*body*/,
                                                         const Body& /*before*/,
                                                         const Body& /*after*/) const {
  return std::make_shared<CentralGravity>(*this);
}

Vector3d CentralGravity::radius(const BodyState& state) const {
  return (state.x_W - gravity_.center_W) + state.x_low_W;
}

Vector3d CentralGravity::gradientTorque(const Body& body, const BodyState& state) const {
  const Vector3d r_W = radius(state);
  const double r = r_W.norm();
  const Vector3d n_P = rotateBack(state.q_WP, Vector3d(r_W / r));
  return 3 * gravity_.mu / (r * r * r) * n_P.cross(wholeInertiaTimes(body, n_P));
}

void CentralGravity::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Body& body = *at.bodies[body_];
  const BodyState& state = at.states[body_];
  const Vector3d r_W = radius(state);
  const double r = r_W.norm();
  wrenches[body_].f_W -= gravity_.mu * body.mass / (r * r * r) * r_W;
  if (gradient_) wrenches[body_].tau_P += gradientTorque(body, state);
}

double CentralGravity::potentialEnergy(const Bodies& at) const {
  return -gravity_.mu * at.bodies[body_]->mass / radius(at.states[body_]).norm();
}

double CentralGravity::rate(const Bodies& at, const std::vector<double>& /*speeds*/) const {
  const double r = radius(at.states[body_]).norm();
  return std::sqrt((gradient_ ? 3 : 1) * gravity_.mu / r) / r;
}

double CentralGravity::externalPower(const Bodies& at) const {
  if (!gradient_) return 0;
  const Body& body = *at.bodies[body_];
  const BodyState& state = at.states[body_];
  return gradientTorque(body, state).dot(angularVelocity(body.inv_I, state.L_P));
}

}  // namespace rigid_body_sim
