#pragma once

#include <cmath>
#include <type_traits>

#include "math/pack.hpp"
#include "math/triple.hpp"

/// The flow of Drag, T: double, or a pack of several bodies with the same bits.
namespace rigid_body_sim {

/// See Drag::Coefficients.
template <class T>
struct DragNumbers {
  T linear, quadratic, angular;
};

/// |v| [m/s]
template <class T>
RIGID_BODY_SIM_INLINE T speedOf(const Triple<T>& v) {
  return squareRoot((v.x * v.x + v.y * v.y) + v.z * v.z);
}

/// 1/n!
constexpr double inverseFactorial(int n) {
  double product = 1;
  for (int k = 2; k <= n; ++k) product *= k;  // exact up to 22!
  return 1 / product;
}

/// Every second term from the n-th on of the series Σ (−x)ⁿ/(n + 1)!, over (−x)ⁿ.
template <int n, class T>
RIGID_BODY_SIM_INLINE T everySecondTerm(const T& square) {
  constexpr int kLast = 18;
  constexpr double kCoefficient = inverseFactorial(n + 1);
  if constexpr (n + 2 > kLast)
    return T(kCoefficient);
  else
    return kCoefficient + square * everySecondTerm<n + 2>(square);
}

/// (1 − e^(−x))/x of |x| ≤ 1, by Taylor's series: what it leaves out is below 1/20!, 4e-19.
template <class T>
RIGID_BODY_SIM_INLINE T smallDecayShare(const T& x) {
  const T square = x * x;
  return everySecondTerm<0>(square) - x * everySecondTerm<1>(square);
}

/// Its derivative, to 2e-4.
template <class T>
RIGID_BODY_SIM_INLINE T decayShareSlope(const T& x) {
  return -1.0 / 2 +
         x * (1.0 / 3 + x * (-1.0 / 8 + x * (1.0 / 30 + x * (-1.0 / 144 + x * (1.0 / 840)))));
}

/// Momentum after h of p' = f − rate p/m, by x = rate h/m of at most 1; left: e^(−x).
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> relaxedBySmall(const Triple<T>& p, const Triple<T>& f, const T& x,
                                               double h, T& left) {
  const T share = smallDecayShare(x);
  left = 1.0 - x * share;
  return left * p + T(h * share) * f;
}

/// Momentum after h of p' = f − (linear + quadratic v̄) p/m with v̄ the mean of the speeds before and
/// after, by Newton's method, where (linear + quadratic v) h/m is at most 1 at any speed v that
/// drag and force allow. It ends, body by body, where a step changes v̄ by so little that the next
/// would by less than rounding; two or three do where drag takes 1e-3 of the momentum.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> relaxedByMeanSpeed(const DragNumbers<T>& drag, const T& mass,
                                                   const Triple<T>& p, const Triple<T>& f,
                                                   double h) {
  constexpr int kMax = 8;
  constexpr double kClose = 1e-11, kNoMomentum = 1e-300;
  const T inv_mass = 1.0 / mass, per_mass = h * inv_mass;
  const T speed = inv_mass * squareRoot(dot(p, p));
  const T x_slope = drag.quadratic * per_mass;
  // by one step of Euler's
  const Triple<T> guess = T(1.0 - (drag.linear + drag.quadratic * speed) * per_mass) * p + h * f;
  T v = 0.5 * (speed + inv_mass * squareRoot(dot(guess, guess)));
  T left, goes_on = T(1.0);
  for (int k = 0; k < kMax && anyNonZero(goes_on); ++k) {
    const T x = (drag.linear + drag.quadratic * v) * per_mass;
    const Triple<T> after = relaxedBySmall(p, f, x, h, left);
    const T size = squareRoot(dot(after, after));
    const T excess = 0.5 * (speed + inv_mass * size) - v;
    const Triple<T> after_slope = T(h * decayShareSlope(x)) * f - left * p;
    const T size_slope = dot(after, after_slope) / (size + kNoMomentum) * x_slope;
    const T step = goes_on * (excess / (1.0 - 0.5 * (inv_mass * size_slope)));
    v = v + step;
    goes_on = oneWherePositive(T(absolute(step) - kClose * v));
  }
  return relaxedBySmall(p, f, T((drag.linear + drag.quadratic * v) * per_mass), h, left);
}

/// Momentum after h of p' = f − (linear + quadratic |p|/m) p/m. The linear part is exact; see Drag.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> relaxedMomentum(const DragNumbers<T>& drag, const T& mass,
                                                const Triple<T>& p, const Triple<T>& f, double h) {
  if (anyNonZero(drag.quadratic)) return relaxedByMeanSpeed(drag, mass, p, f, h);
  T left;
  return relaxedBySmall(p, f, T(drag.linear * (h * (1.0 / mass))), h, left);
}

/// Gain after h of L' = τ − rate L, by the share of h that decay leaves.
template <class T>
RIGID_BODY_SIM_INLINE T relaxedGain(const T& share, const T& tau, const T& rate, const T& L,
                                    double h) {
  return h * share * (tau - rate * L);
}

}  // namespace rigid_body_sim
