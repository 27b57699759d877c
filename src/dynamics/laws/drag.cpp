#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/drag.hpp>

namespace rigid_body_sim {
namespace {

/// (1 − e^(−x))/x, 1 at zero.
double decayShare(double x) { return x == 0 ? 1 : -std::expm1(-x) / x; }

/// Solution after h of y' = f − rate y, started at y.
Vector3d relaxed(const Vector3d& y, const Vector3d& f, double rate, double h) {
  const double x = rate * h;
  return std::exp(-x) * y + h * decayShare(x) * f;
}

/// Momentum after h of p' = f − (linear + quadratic v̄) p/m with v̄ the mean of the speeds before and
/// after: the root of excess(v̄), bracketed, by regula falsi (Illinois).
Vector3d relaxedQuadratic(const Body& body, const Vector3d& p, const Vector3d& f, double h) {
  const double speed = p.norm() / body.mass;
  const auto after = [&](double mean_speed) {
    return relaxed(p, f, (body.drag.linear + body.drag.quadratic * mean_speed) / body.mass, h);
  };
  const auto excess = [&](double mean_speed) {
    return 0.5 * (speed + after(mean_speed).norm() / body.mass) - mean_speed;
  };
  // no drag leaves more than the momentum and the impulse together
  double low = 0.5 * speed, high = speed + 0.5 * h * f.norm() / body.mass;
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

}  // namespace

void addDrag(const Body& body, const BodyState& state, Wrench& wrench) {
  const Vector3d v_W = state.p_W / body.mass;
  wrench.f_W -= (body.drag.linear + body.drag.quadratic * v_W.norm()) * v_W;
  wrench.tau_P -= body.drag.angular * angularVelocity(body.inv_I, state.L_P);
}

double dragRate(const Body& body, double speed) {
  return std::max((body.drag.linear + 2 * body.drag.quadratic * speed) / body.mass,
                  body.drag.angular * body.inv_I.maxCoeff());
}

double dragPower(const Body& body, const BodyState& state) {
  const double v = state.p_W.norm() / body.mass;
  return (body.drag.linear + body.drag.quadratic * v) * v * v +
         body.drag.angular * angularVelocity(body.inv_I, state.L_P).squaredNorm();
}

void dragKick(const Body& body, const Wrench& wrench, double h, BodyState& state) {
  state.p_W = body.drag.quadratic > 0
                  ? relaxedQuadratic(body, state.p_W, wrench.f_W, h)
                  : relaxed(state.p_W, wrench.f_W, body.drag.linear / body.mass, h);
  const Vector3d tau_P = rotateBack(state.q_WP, wrench.tau_W) + wrench.tau_P;
  const Vector3d rate = body.drag.angular * body.inv_I;
  Vector3d gain_P;
  for (int i = 0; i < 3; ++i) {
    const double x = rate(i) * h;
    gain_P(i) = h * decayShare(x) * (tau_P(i) - rate(i) * state.L_P(i));
  }
  state.L_P += gain_P;
  state.L_W += rotate(state.q_WP, gain_P);
}

}  // namespace rigid_body_sim
