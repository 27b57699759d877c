#include "dynamics/medium/linear_translation.hpp"

#include <cmath>
#include <limits>

#include "dynamics/rotation/free_motion.hpp"

namespace rigid_body_sim {
namespace {

/// φ₁(z), z >= 0
double meanDecay(double z) { return z == 0 ? 1 : -std::expm1(-z) / z; }

/// Below it digits would be lost in sums that hardly differ from what they start from.
constexpr double kMuchDecay = 1;

/// φ₂(z), z >= 0: for little decay by Σ (−z)ⁿ/(n + 2)!, as 1 − φ₁ would lose digits; 1/20! is
/// rounding.
double secondMeanDecay(double z) {
  if (z >= kMuchDecay) return (1 - meanDecay(z)) / z;
  double sum = 0;
  for (int n = 18; n >= 0; --n) sum = (1 - z * sum) / (n + 2);
  return sum;
}

}  // namespace

void LinearTranslation::move(const BodyState& start, double dt, BodyState& state) const {
  const double z = dt > 0 ? rate_ * dt : 0, mean = meanDecay(z), second = secondMeanDecay(z);
  const Vector3d u_W = velocityThrough(start);
  Vector3d path;
  if (z < kMuchDecay) {
    state.p_W = start.p_W + mass_ * (dt * mean * a_W_ + std::expm1(-z) * u_W);
    path = dt * (start.p_W / mass_ + second * (dt * a_W_ - z * u_W));
  } else {
    state.p_W = mass_ * (medium_W_ + std::exp(-z) * u_W + dt * mean * a_W_);
    path = dt * (medium_W_ + mean * u_W + dt * second * a_W_);
  }
  state.x_W = start.x_W;
  state.x_low_W = start.x_low_W;
  moveBy(path, state);
}

// An integrand e^(−2z) over 0.7 decays, seven nodes: the error is below (2 · 0.7)¹⁴ 7!⁴/(15 · 14!³)
// = 7e-18 of it.
double LinearTranslation::smoothFor(const BodyState& start, double dt) const {
  constexpr double kAnyLength = std::numeric_limits<double>::infinity();
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  if (rate_ == 0) return kAnyLength;
  const Vector3d steady_W = a_W_ / rate_;
  const double left =
      std::exp(dt > 0 ? -rate_ * dt : 0) * (velocityThrough(start) - steady_W).norm();
  const bool decays = left > kRounding * (steady_W.norm() + medium_W_.norm());
  return decays ? 0.7 / rate_ : kAnyLength;
}

}  // namespace rigid_body_sim
