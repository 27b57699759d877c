#pragma once

#include <cmath>
#include <memory>

#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/worlds.hpp"

/// A ball that falls into a tether, with its closed form.
namespace rigid_body_sim::test {

/// 1 kg that falls from where the tether ends, L above the point at which it is taut, with a
/// damping of c < 2 √k.
class TetherDrop {
 public:
  explicit TetherDrop(double damping) : c_(damping) {}

  long double tautAt() const { return std::sqrt(2 * L / g); }

  /// Where the pull is zero again.
  long double limpAt() const {
    long double before = 0.1L, after = 0.4L;
    for (int i = 0; i < 100; ++i)
      (taut((before + after) / 2).pull > 0 ? before : after) = (before + after) / 2;
    return tautAt() + after;
  }

  /// z of the body at a time [s] before it is taut again.
  double z(long double t) const {
    if (t < tautAt()) return static_cast<double>(-g * t * t / 2);
    if (t < limpAt()) return static_cast<double>(-L - taut(t - tautAt()).s);
    const At limp = taut(limpAt() - tautAt());
    const long double free = t - limpAt();
    return static_cast<double>(-L - (limp.s + limp.v * free + g * free * free / 2));
  }

 private:
  static constexpr long double g = 10, k = 200, L = 0.5L;

  /// The extension, its rate and the pull.
  struct At {
    long double s, v, pull;
  };

  /// t after it is taut: s = m g/k + e^(−bt) (A cos ωt + B sin ωt) with b = c/2, ω² = k − b², from
  /// s = 0 and s′ = √(2 g L).
  At taut(long double t) const {
    const long double b = c_ / 2, w = std::sqrt(k - b * b), rest = g / k;
    const long double A = -rest, B = (std::sqrt(2 * g * L) + b * A) / w;
    const long double e = std::exp(-b * t), C = std::cos(w * t), S = std::sin(w * t);
    const long double s = rest + e * (A * C + B * S);
    const long double v = e * ((w * B - b * A) * C - (w * A + b * B) * S);
    return {s, v, k * s + c_ * v};
  }

  long double c_;
};

inline Bench droppedBall(double damping = 3) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  bench.add(principalBody("ball", 1, {0.1, 0.1, 0.1}), BodyFrameMotion());
  bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{kWorld, Vector3d::Zero()},
                                                      Spring::End{0, Vector3d::Zero()},
                                                      Tether::Constants{200, damping, 0.5}));
  return bench;
}

}  // namespace rigid_body_sim::test
