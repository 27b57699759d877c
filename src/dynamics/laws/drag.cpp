#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/drag.hpp>

#include "dynamics/laws/drag_flow.hpp"
#include "dynamics/laws/drag_kink.hpp"
#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/medium_load.hpp"
#include "dynamics/rotation/free_motion.hpp"

namespace rigid_body_sim {
namespace {

/// (1 − e^(−x))/x
double decayShare(double x) { return std::abs(x) <= 1 ? smallDecayShare(x) : -std::expm1(-x) / x; }

/// Solution after h of y' = f − rate y, started at y.
Vector3d relaxed(const Vector3d& y, const Vector3d& f, double rate, double h) {
  const double x = rate * h;
  return std::exp(-x) * y + h * decayShare(x) * f;
}

/// Momentum after h of p' = f − (linear + quadratic v̄) p/m with v̄ the mean of the speeds before and
/// after: the root of excess(v̄), bracketed, by regula falsi (Illinois).
Vector3d relaxedQuadratic(const Drag::Coefficients& drag, double mass, const Vector3d& p,
                          const Vector3d& f, double h) {
  const double speed = p.norm() / mass;
  const auto after = [&](double mean_speed) {
    return relaxed(p, f, (drag.linear + drag.quadratic * mean_speed) / mass, h);
  };
  const auto excess = [&](double mean_speed) {
    return 0.5 * (speed + after(mean_speed).norm() / mass) - mean_speed;
  };
  // no drag leaves more than the momentum and the impulse together
  double low = 0.5 * speed, high = speed + 0.5 * h * f.norm() / mass;
  double e_low = excess(low), e_high = excess(high);
  if (!(e_low > 0)) return after(low);
  int last_side = 0;
  for (int i = 0; i < 100 && e_high < 0 && high - low > 4e-16 * high; ++i) {
    const double guess = (low * e_high - high * e_low) / (e_high - e_low);
    const double e = excess(guess);
    if (std::abs(e) <= 2e-16 * guess) return after(guess);
    if (e > 0) {
      low = guess;
      e_low = e;
      if (last_side > 0) e_high /= 2;
    } else {
      high = guess;
      e_high = e;
      if (last_side < 0) e_low /= 2;
    }
    last_side = e > 0 ? 1 : -1;
  }
  return after(high);
}

/// As packs have it where drag takes no more than a part of the momentum, as in any step that an
/// integrator follows.
Vector3d relaxedMomentumOf(const Drag::Coefficients& drag, double mass, const Vector3d& p,
                           const Vector3d& f, double h) {
  const double fastest = drag.quadratic > 0 ? (p.norm() + h * f.norm()) / mass : 0;
  if (std::abs((drag.linear + drag.quadratic * fastest) / mass * h) <= 1)
    return vectorOf(relaxedMomentum<double>({drag.linear, drag.quadratic, drag.angular}, mass,
                                            tripleOf(p), tripleOf(f), h));
  return drag.quadratic > 0 ? relaxedQuadratic(drag, mass, p, f, h)
                            : relaxed(p, f, drag.linear / mass, h);
}

}  // namespace

Drag::Drag(std::size_t body, const Coefficients& coefficients)
    : body_(body), coefficients_(coefficients) {
  requireNotNegative("drag", "linear must be >= 0 N s/m", coefficients.linear);
  requireNotNegative("drag", "quadratic must be >= 0 N s^2/m^2", coefficients.quadratic);
  requireNotNegative("drag", "angular must be >= 0 N m s", coefficients.angular);
}

std::shared_ptr<const ForceLaw> Drag::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  return std::make_shared<Drag>(index(body_), coefficients_);
}

/// It acts at the centre of mass, wherever that is.
std::shared_ptr<const ForceLaw> Drag::reframed(std::size_t /*body*/, const Body& /*before*/,
                                               const Body& /*after*/) const {
  return std::make_shared<Drag>(*this);
}

void Drag::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Body& body = *at.bodies[body_];
  const BodyState& state = at.states[body_];
  const Vector3d v_W = state.p_W / body.mass;
  Wrench& wrench = wrenches[body_];
  wrench.f_W -= (coefficients_.linear + coefficients_.quadratic * speedOf(tripleOf(v_W))) * v_W;
  wrench.tau_P -= coefficients_.angular * angularVelocity(body.inv_I, state.L_P);
}

double Drag::externalPower(const Bodies& at) const {
  const Body& body = *at.bodies[body_];
  const BodyState& state = at.states[body_];
  const double v = state.p_W.norm() / body.mass;
  return -(coefficients_.linear + coefficients_.quadratic * v) * v * v -
         coefficients_.angular * angularVelocity(body.inv_I, state.L_P).squaredNorm();
}

void Drag::addStiffness(const std::vector<const Body*>& bodies,
                        std::vector<Stiffness>& stiffness) const {
  const Body& body = *bodies[body_];
  stiffness[body_].decay +=
      std::max(coefficients_.linear / body.mass, coefficients_.angular * body.inv_I.maxCoeff());
}

double Drag::rate(const Bodies& at, const std::vector<double>& speeds) const {
  if (coefficients_.quadratic == 0) return 0;
  return (coefficients_.linear + 2 * coefficients_.quadratic * speeds[body_]) /
         at.bodies[body_]->mass;
}

double Drag::distanceToKink(const Bodies& at, const std::vector<BodyMotion>& motions, double h,
                            double negligible) const {
  const double mass = at.bodies[body_]->mass;
  const BodyAcceleration& a = motions[body_].acceleration;
  return distanceToDragKink(at.states[body_].p_W / mass, a.felt_W + a.g_W,
                            coefficients_.quadratic / mass, h, negligible);
}

void Drag::addMedium(const Bodies& /*at*/, MediumLoad& load) const {
  load.linear = coefficients_.linear;
  load.quadratic = coefficients_.quadratic;
  load.angular_P = coefficients_.angular * Matrix3d::Identity();
}

void Drag::kick(const Body& body, const Wrench& wrench, double h, BodyState& state) const {
  state.p_W = relaxedMomentumOf(coefficients_, body.mass, state.p_W, wrench.f_W, h);
  const Vector3d tau_P = wrench.tau_P + rotateBack(state.q_WP, wrench.tau_W);
  const Vector3d rate = coefficients_.angular * body.inv_I;
  Vector3d gain_P;
  for (int i = 0; i < 3; ++i)
    gain_P(i) = relaxedGain(decayShare(rate(i) * h), tau_P(i), rate(i), state.L_P(i), h);
  state.L_P += gain_P;
  state.L_W += rotate(state.q_WP, gain_P);
}

}  // namespace rigid_body_sim
