#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// A scalar of 113 bits, for motions of many turns; slow. Arithmetic alone is used, no library.
__extension__ typedef __float128 Quad;

/// Attitude and angular velocity of a free body, in the reference's scalar.
template <class R>
struct ReferenceRotation {
  std::array<R, 4> q;  ///< w, x, y, z
  std::array<R, 3> w;  ///< [rad/s] in principal axes
};

/// Euler's equations and the attitude by Taylor series of order 30 in a scalar R with more digits
/// than the method under test; nothing of the closed form is used. For torque-free motion:
///   ω₁' = (I₂ − I₃)/I₁ ω₂ ω₃ and cyclic,   q' = ½ q ω.
/// Truncation stays below the rounding of R.
template <class R>
class ReferenceFreeRotation {
 public:
  ReferenceFreeRotation(const Vector3d& I, const Quaterniond& q_WP, const Vector3<long double>& L_P)
      : I_{R(I(0)), R(I(1)), R(I(2))} {
    state_.q = {R(q_WP.w()), R(q_WP.x()), R(q_WP.y()), R(q_WP.z())};
    for (std::size_t i = 0; i < 3; ++i) state_.w[i] = R(L_P(int(i))) / I_[i];
    for (std::size_t i = 0; i < 3; ++i) ratio_[i] = (I_[(i + 1) % 3] - I_[(i + 2) % 3]) / I_[i];
  }

  const ReferenceRotation<R>& state() const { return state_; }

  std::array<R, 3> angularMomentum() const {
    return {I_[0] * state_.w[0], I_[1] * state_.w[1], I_[2] * state_.w[2]};
  }

  /// Goes on by dt [s], of either sign.
  void advance(R dt) {
    while (dt != R(0)) {
      // time in units of the largest component of the angular velocity keeps coefficients near 1
      R unit = R(0);
      for (const R& w : state_.w) unit = std::max(unit, w < R(0) ? -w : w);
      if (!(unit > R(0))) return;
      expand(unit);
      const R longest = dt < R(0) ? -R(range()) / unit : R(range()) / unit;
      const bool last = dt < R(0) ? dt >= longest : dt <= longest;
      const R step = last ? dt : leadingBits(longest);
      evaluate(step * unit, unit);
      dt = last ? R(0) : dt - step;
    }
  }

 private:
  static constexpr std::size_t kOrder = 30;

  /// x without its last forty bits: what is left of the time after such a step is exact.
  static R leadingBits(R x) {
    const R spread = x * R((1LL << 40) + 1);
    return spread - (spread - x);
  }

  /// Taylor coefficients of ω/unit and q in time·unit, by Cauchy products.
  void expand(R unit) {
    for (std::size_t i = 0; i < 3; ++i) w_[i][0] = state_.w[i] / unit;
    for (std::size_t i = 0; i < 4; ++i) q_[i][0] = state_.q[i];
    for (std::size_t k = 0; k < kOrder; ++k) {
      std::array<R, 3> ww{};
      std::array<R, 4> qw{};
      for (std::size_t j = 0; j <= k; ++j) {
        const R x = w_[0][k - j], y = w_[1][k - j], z = w_[2][k - j];
        ww[0] += w_[1][j] * z;
        ww[1] += w_[2][j] * x;
        ww[2] += w_[0][j] * y;
        const R a = q_[0][j], b = q_[1][j], c = q_[2][j], d = q_[3][j];
        qw[0] -= b * x + c * y + d * z;
        qw[1] += a * x + c * z - d * y;
        qw[2] += a * y - b * z + d * x;
        qw[3] += a * z + b * y - c * x;
      }
      for (std::size_t i = 0; i < 3; ++i) w_[i][k + 1] = ratio_[i] * ww[i] / R(int(k) + 1);
      for (std::size_t i = 0; i < 4; ++i) q_[i][k + 1] = qw[i] / R(2 * (int(k) + 1));
    }
  }

  /// Step at which the last two terms fall below the rounding of R (Jorba & Zou 2005).
  double range() const {
    static const double rounding = [] {
      R e = R(1);
      while (R(1) + e / R(2) != R(1)) e /= R(2);
      return double(e) / 4;
    }();
    double shortest = 1e300;
    for (const std::size_t k : {kOrder - 1, kOrder}) {
      double size = 1e-300;
      for (const auto& w : w_) size = std::max(size, std::abs(double(w[k])));
      for (const auto& q : q_) size = std::max(size, std::abs(double(q[k])));
      shortest = std::min(shortest, std::pow(rounding / size, 1.0 / double(k)));
    }
    return shortest;
  }

  void evaluate(R step, R unit) {
    for (std::size_t i = 0; i < 3; ++i) state_.w[i] = horner(w_[i], step) * unit;
    for (std::size_t i = 0; i < 4; ++i) state_.q[i] = horner(q_[i], step);
  }

  static R horner(const std::array<R, kOrder + 1>& c, R x) {
    R sum = c[kOrder];
    for (std::size_t k = kOrder; k-- > 0;) sum = sum * x + c[k];
    return sum;
  }

  std::array<R, 3> I_;
  std::array<R, 3> ratio_;
  ReferenceRotation<R> state_;
  std::array<std::array<R, kOrder + 1>, 3> w_;
  std::array<std::array<R, kOrder + 1>, 4> q_;
};

/// Angle [rad] between an attitude and the reference's, worked out in long double; either
/// quaternion may be off unit norm.
template <class R>
double angleToReference(const Quaterniond& q_WP, const ReferenceRotation<R>& reference) {
  using L = long double;
  const Quaternion<L> a(q_WP.w(), q_WP.x(), q_WP.y(), q_WP.z());
  const Quaternion<L> b(L(reference.q[0]), L(reference.q[1]), L(reference.q[2]), L(reference.q[3]));
  const Quaternion<L> d = a.conjugate() * b;
  return double(2 * std::atan2(d.vec().norm(), std::abs(d.w())));
}

}  // namespace rigid_body_sim
