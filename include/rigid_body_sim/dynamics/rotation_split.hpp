#pragma once

#include <cmath>
#include <utility>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Two of the three parts into which the free rotation splits. With r the remaining axis,
///   T = |L|²/(2 I_r) + ½ k_a L_a² + ½ k_b L_b²,   kᵢ = 1/Iᵢ − 1/I_r.
/// The first part depends on |L| alone: its flow is a rotation about L in the world and commutes
/// with the others, so that only two parts do not commute; one where two moments are equal.
/// Source: Touma & Wisdom, Astron. J. 107 (1994) 1189; Fassò, J. Comput. Phys. 189 (2003) 527.
template <class T>
struct RotationSplit {
  int a, b;    ///< axes, 0 … 2
  T k_a, k_b;  ///< [1/(kg m²)]
  T inv_I_r;   ///< [1/(kg m²)]
};

/// The split with the smallest second-order error: |k_a| <= |k_b|, |k_a k_b| (|k_b| + 2 |k_a|)
/// least.
template <class T>
RotationSplit<T> rotationSplit(const Vector3<T>& inv_I) {
  using std::abs;
  RotationSplit<T> best{};
  T least = T(-1);
  for (int r = 0; r < 3; ++r) {
    int a = (r + 1) % 3, b = (r + 2) % 3;
    if (abs(inv_I(a) - inv_I(r)) > abs(inv_I(b) - inv_I(r))) std::swap(a, b);
    const T k_a = inv_I(a) - inv_I(r), k_b = inv_I(b) - inv_I(r);
    const T error = abs(k_a) * abs(k_b) * (abs(k_b) + T(2) * abs(k_a));
    if (least < T(0) || error < least) {
      least = error;
      best = {a, b, k_a, k_b, inv_I(r)};
    }
  }
  return best;
}

}  // namespace rigid_body_sim
