#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/wide.hpp"

/// Elliptic integrals and functions of real argument. The modulus is given by the complementary
/// parameter mc = 1 − k², because near the separatrix (k → 1) all digits are in mc.
/// Source: NIST Digital Library of Mathematical Functions (DLMF), chapters 19 and 22; B. C.
/// Carlson, Numerical Algorithms 10 (1995) 13; R. Bulirsch, Numerische Mathematik 7 (1965) 78.
namespace rigid_body_sim {

/// RC(1, 1 + e) = atan(√e)/√e for e ≥ 0, Carlson's degenerate integral.
template <class T>
T carlsonRC1p(T e) {
  using std::atan;
  using std::sqrt;
  if (e < T(1e-3)) {
    // the terms shrink by e: seven of them reach 1e-20
    T sum = T(1) / T(13);
    for (int odd = 11; odd >= 1; odd -= 2) sum = T(1) / T(odd) - e * sum;
    return sum;
  }
  const T root = sqrt(e);
  return atan(root) / root;
}

/// Carlson's symmetric integral of the third kind,
///   RJ(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t+p) √((t+x)(t+y)(t+z))),
/// for p ≥ x, y, z ≥ 0, at most one of x, y, z zero. Duplication, then the series of DLMF 19.36.2.
template <class T>
T carlsonRJ(T x, T y, T z, T p) {
  using std::abs;
  using std::pow;
  using std::sqrt;
  const T mean0 = (x + y + z + T(2) * p) / T(5);
  static const T series_range = pow(T(2) * std::numeric_limits<T>::epsilon(), T(1) / T(8));
  const T spread0 =
      std::max({abs(mean0 - x), abs(mean0 - y), abs(mean0 - z), abs(mean0 - p)}) / series_range;
  T delta = (p - x) * (p - y) * (p - z);
  T mean = mean0;
  T quarter = T(1);
  T sum = T(0);
  const T x0 = x, y0 = y, z0 = z;
  while (quarter * spread0 > mean) {
    const T sx = sqrt(x), sy = sqrt(y), sz = sqrt(z), sp = sqrt(p);
    const T shift = sx * (sy + sz) + sy * sz;
    const T d = (sp + sx) * (sp + sy) * (sp + sz);
    sum += quarter / d * carlsonRC1p(delta / (d * d));
    x = (x + shift) / T(4);
    y = (y + shift) / T(4);
    z = (z + shift) / T(4);
    p = (p + shift) / T(4);
    mean = (mean + shift) / T(4);
    delta /= T(64);
    quarter /= T(4);
  }
  const T X = (mean0 - x0) * quarter / mean;
  const T Y = (mean0 - y0) * quarter / mean;
  const T Z = (mean0 - z0) * quarter / mean;
  const T P = -(X + Y + Z) / T(2);
  const T xyz = X * Y * Z;
  const T e2 = X * Y + Y * Z + Z * X - T(3) * P * P;
  const T e3 = xyz + T(2) * e2 * P + T(4) * P * P * P;
  const T e4 = (T(2) * xyz + e2 * P + T(3) * P * P * P) * P;
  const T e5 = xyz * P * P;
  const T series = T(1) - T(3) * e2 / T(14) + e3 / T(6) + T(9) * e2 * e2 / T(88) -
                   T(3) * e4 / T(22) - T(9) * e2 * e3 / T(52) + T(3) * e5 / T(26) -
                   e2 * e2 * e2 / T(16) + T(3) * e3 * e3 / T(40) + T(3) * e2 * e4 / T(20) +
                   T(45) * e2 * e2 * e3 / T(272) - T(9) * (e3 * e4 + e2 * e5) / T(68);
  return quarter * series / (mean * sqrt(mean)) + T(6) * sum;
}

/// The complete integrals that belong to one modulus and one characteristic.
template <class T>
struct CompleteIntegrals {
  T K;           ///< K = ∫₀^{π/2} dφ / √(1 − k² sin²φ)
  T Pi_minus_K;  ///< Π(ν) − K, without cancellation;  Π's integrand has the factor 1/(1−ν sin²φ)
};

/// K and Π − K for 0 < mc ≤ 1 and ν ≤ 0 by arithmetic-geometric means,
///   K = π / (2 M(1, √mc)),  Π − K = K ν/(2(1−ν)) Σ Qₙ.
/// Source: DLMF 19.8.5 to 19.8.7.
template <class T>
CompleteIntegrals<T> completeIntegrals(T mc, T nu) {
  using std::abs;
  using std::sqrt;
  constexpr T kEpsilon = std::numeric_limits<T>::epsilon();
  T a = T(1), g = sqrt(mc), p = sqrt(T(1) - nu);
  T Q = T(1), sum = T(1);
  constexpr int kMaxIterations = 40;  // 20 suffice for the smallest mc of a long double
  for (int i = 0; i < kMaxIterations && (abs(a - g) > kEpsilon * a || abs(Q) > kEpsilon * sum);
       ++i) {
    const T ag = a * g;
    const T p2 = p * p;
    const T inverse = T(1) / ((p2 + ag) * p);
    Q *= (p2 - ag) * p * inverse / T(2);
    sum += Q;
    p = (p2 + ag) * (p2 + ag) * inverse / T(2);
    a = (a + g) / T(2);
    g = sqrt(ag);
  }
  const T K = kPi<T> / (T(2) * a);
  return {K, K * nu / (T(2) * (T(1) - nu)) * sum};
}

/// Values of the Jacobi elliptic functions at one argument.
template <class T>
struct JacobiValues {
  T sn, cn, dn;
};

/// Π(ν; u) − u, the incomplete integral of the third kind beyond that of the first, from the
/// functions at |u| ≤ K, with −1 ≤ ν ≤ 0:
///   ν/3 sn³ RJ(cn², dn², 1, 1 − ν sn²).
/// The first duplication is done here, on the roots that are at hand: it stays good where the
/// squares of cn and dn underflow, and needs no difference of the arguments.
/// Source: DLMF 19.25.14.
template <class T>
T incompletePiMinusF(const JacobiValues<T>& u, T k2, T nu) {
  using std::abs;
  using std::sqrt;
  const T sn2 = u.sn * u.sn;
  const T cn = abs(u.cn);
  const T p = T(1) - nu * sn2;
  const T root = sqrt(p);
  const T d = (root + cn) * (root + u.dn) * (root + T(1));
  const T delta = -(T(1) - nu) * (k2 - nu) * nu * sn2 * sn2 * sn2;
  const T shift = cn * (u.dn + T(1)) + u.dn;
  const T rest = carlsonRJ((cn * cn + shift) / T(4), (u.dn * u.dn + shift) / T(4),
                           (T(1) + shift) / T(4), (p + shift) / T(4));
  return nu * u.sn * sn2 * (rest / T(12) + T(2) / d * carlsonRC1p(delta / (d * d)));
}

/// sn, cn, dn of one modulus, 0 < mc ≤ 1, by the descending Gauss transformation along the
/// arithmetic-geometric mean of 1 and √mc, which is kept between evaluations. Accurate to a few
/// units of rounding, relative to 1, for |u| ≤ K; callers reduce u by multiples of 2K.
template <class T>
class JacobiFunctions {
 public:
  explicit JacobiFunctions(Wide<T> mc) {
    using std::abs;
    using std::sqrt;
    // the next difference is (a − g)²/8
    const T close = sqrt(std::numeric_limits<T>::epsilon());
    T a = T(1), g = T(sqrt(mc));
    do {
      Level& level = levels_[static_cast<std::size_t>(count_++)];
      level.a = a;
      level.g = g;
      a = (level.a + level.g) / T(2);
      level.inverse_next_a = T(1) / a;
      if (abs(level.a - level.g) <= close * level.a) break;
      g = sqrt(level.a * level.g);
    } while (count_ < kMaxLevels);
    mean_ = a;
  }

  JacobiValues<T> at(T u) const {
    using std::abs;
    using std::cos;
    using std::sin;
    using std::sqrt;
    // second-order terms are below rounding, and 1/u² might overflow
    if (abs(u) < sqrt(std::numeric_limits<T>::epsilon()) / T(2)) return {u, T(1), T(1)};
    const T phase = mean_ * u;
    const T s = sin(phase);
    // x = a cn/sn of each level, from the circular functions at the mean down to the modulus
    T x = mean_ * cos(phase) / s;
    T dn = T(1);
    for (int i = count_ - 1; i >= 0; --i) {
      const Level& level = levels_[static_cast<std::size_t>(i)];
      const T w = x * x * level.inverse_next_a;
      x *= dn;
      dn = (level.g + w) / (level.a + w);
    }
    const T sn = std::copysign(T(1) / sqrt(T(1) + x * x), s);
    return {sn, x * sn, dn};
  }

 private:
  static constexpr int kMaxLevels = 20;
  struct Level {
    T a, g, inverse_next_a;
  };
  std::array<Level, kMaxLevels> levels_;
  int count_ = 0;
  T mean_;
};

}  // namespace rigid_body_sim
