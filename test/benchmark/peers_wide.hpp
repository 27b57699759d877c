#pragma once

#include <array>
#include <cmath>

/// Vectors in long double and a method of steps, for truths that share nothing with ours or with
/// the engines.
namespace rigid_body_sim::wide {

using Real = long double;
using V = std::array<Real, 3>;

inline V operator+(const V& a, const V& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline V operator*(Real s, const V& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline V operator-(const V& a, const V& b) { return a + Real{-1} * b; }
inline Real dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Real norm(const V& a) { return std::sqrt(dot(a, a)); }
inline V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Numbers>
Numbers ahead(Numbers y, Real h, const Numbers& rate) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * rate[i];
  return y;
}

/// After so many steps of h of the classical Runge–Kutta method from t on; rateAt(t, y).
template <class Numbers, class Rate>
Numbers advanced(Numbers y, Real t, Real h, int steps, const Rate& rateAt) {
  for (int k = 0; k < steps; ++k, t += h) {
    const Numbers k1 = rateAt(t, y), k2 = rateAt(t + h / 2, ahead(y, h / 2, k1)),
                  k3 = rateAt(t + h / 2, ahead(y, h / 2, k2)), k4 = rateAt(t + h, ahead(y, h, k3));
    y = ahead(ahead(ahead(ahead(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return y;
}

}  // namespace rigid_body_sim::wide
