#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <rigid_body_sim/dynamics/contact.hpp>

namespace rigid_body_sim {

/// δᵖ, continued below zero as an odd function: the stages of a step look past the instant of a
/// touch, and find a smooth force there.
inline double oddPower(double depth, double p) {
  if (p == 1) return depth;
  if (p == 1.5) return depth * std::sqrt(std::abs(depth));
  return std::copysign(std::pow(std::abs(depth), p), depth);
}

/// What rounding may shift a difference by, as a share of its terms.
constexpr double kDepthRounding = 8 * std::numeric_limits<double>::epsilon();

/// A point that touches: the normal force and its energy.
struct NormalPoint {
  double depth = 0;      ///< δ [m]
  double rate = 0;       ///< δ' [m/s]
  bool clipped = false;  ///< whether it would pull: 1 + d δ' < 0

  /// Below zero where it begins to touch, or lets go: as δ passes zero the way that δ' shows.
  /// Against that way only where δ is beyond its rounding: else what has just let go would touch
  /// again at once. What lies on the plane exactly, at rest, touches it. rate_rounding(): what δ'
  /// may err by; asked for where that matters.
  template <class Rounding>
  double touchGuard(bool touches, double depth_rounding, const Rounding& rate_rounding) const {
    constexpr double kTiny = 1e-300;
    if (std::abs(depth) > depth_rounding) return touches ? depth : -depth;
    const bool leaves = rate < -rate_rounding();
    if (touches != leaves) return depth_rounding;
    return depth == 0 ? -kTiny : (touches ? depth : -depth);
  }

  /// Below zero where it begins, or ceases, to push; nothing to guard where it does not touch.
  double pushGuard(const ContactParameters& c, bool touches) const {
    if (!touches) return 1;
    const double push = 1 + c.dissipation * rate;
    return clipped ? -push : push;
  }

  /// ∂N/∂δ at rest, p k δ^(p−1)  [N/m]
  double stiffness(const ContactParameters& c) const {
    return c.exponent * c.stiffness * std::pow(std::max(depth, 0.0), c.exponent - 1);
  }
  /// ∂N/∂δ', k δᵖ d  [N s/m]
  double damping(const ContactParameters& c) const {
    return c.stiffness * std::pow(std::max(depth, 0.0), c.exponent) * c.dissipation;
  }

  /// [s] See ForceLaw::longestStep; mass [kg]: the reduced mass.
  double longestStep(const ContactParameters& c, double mass, double precision) const;

  /// k δᵖ (1 + d δ') or 0  [N]
  double force(const ContactParameters& c) const {
    return clipped ? 0 : c.stiffness * oddPower(depth, c.exponent) * (1 + c.dissipation * rate);
  }
  /// k δᵖ⁺¹/(p + 1)  [J]
  double energy(const ContactParameters& c) const {
    return c.stiffness * std::abs(depth) * std::abs(oddPower(depth, c.exponent)) / (c.exponent + 1);
  }
  /// −k δᵖ d δ'², or, where it would pull, what of the energy is lost: k δᵖ δ' < 0  [W]
  double externalPower(const ContactParameters& c) const {
    const double elastic = c.stiffness * oddPower(depth, c.exponent);
    return clipped ? elastic * rate : -elastic * c.dissipation * rate * rate;
  }
};

/// How friction yields: the spring and the damper of one of its elements.
struct Bristle {
  double stiffness = 0;  ///< [N/m] or [N m]
  double damping = 0;    ///< [N s/m] or [N m s]

  bool exists() const { return stiffness > 0; }
};

/// Pull of a bristle that is stretched by s at the velocity v, of at most `cap`, and the rate of s:
///   sticks:  −q,  v;     slips:  −cap q/|q|,  v − (1 − cap/|q|) q/c;     q = k s + c v
template <class V>
struct BristlePull {
  V pull, rate;

  BristlePull(const Bristle& bristle, const V& s, const V& v, double cap, bool slips) {
    const V q = bristle.stiffness * s + bristle.damping * v;
    const double size = q.norm();
    if (!slips) {
      pull = -q;
      rate = v;
    } else if (size > 0) {
      const double share = cap / size;
      pull = -share * q;
      rate = v - (1 - share) / bristle.damping * q;
    } else {
      pull = V::Zero();
      rate = v;
    }
  }

  /// [W] Lost in its damper and its slider: pull · v + k s · s' <= 0.
  double power(const Bristle& bristle, const V& s, const V& v) const {
    return pull.dot(v) + bristle.stiffness * s.dot(rate);
  }

  /// [N] |q| − cap
  static double excess(const Bristle& bristle, const V& s, const V& v, double cap) {
    return (bristle.stiffness * s + bristle.damping * v).norm() - cap;
  }
};

/// The bristles of a contact under the reduced mass m: k_t = μ m g₀/b, c_t = 0.4 √(k_t m); those of
/// rolling, at the lever ℓ: k_r = ρ m g₀ ℓ/b, c_r = 0.4 √(k_r m) ℓ.
struct Bristles {
  static constexpr double kEarthGravity = 9.80665;  // [m/s²] of the definition of `breakaway`
  static constexpr double kDamping = 0.4;

  static Bristle sliding(const ContactParameters& c, double mass) {
    const double k = c.friction * mass * kEarthGravity / c.breakaway;
    return {k, kDamping * std::sqrt(k * mass)};
  }
  static Bristle rolling(const ContactParameters& c, double mass, double lever) {
    const double k = c.rolling_friction * mass * kEarthGravity * lever / c.breakaway;
    return {k, kDamping * std::sqrt(k * mass) * lever};
  }
  /// [N] By how much a bristle must be pulled beyond its cap before it slips: rounding would switch
  /// it to and fro.
  static double margin(double mass) { return 1e-14 * mass * kEarthGravity; }
};

/// Throws std::invalid_argument for parameters that break a rule.
void checkParameters(const ContactParameters& parameters);

}  // namespace rigid_body_sim
