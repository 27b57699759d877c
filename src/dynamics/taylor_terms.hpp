#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <rigid_body_sim/math/types.hpp>

/// What the recursion of the Taylor segment is written in.
namespace rigid_body_sim {

template <class T>
using Array4 = Eigen::Array<T, 4, 1>;

template <class T>
Array4<T> lanes(const Vector3<T>& v) {
  return Array4<T>(v.x(), v.y(), v.z(), T(0));
}

template <class T>
T maxAbs(const Array4<T>& a) {
  return a.abs().maxCoeff();
}

/// 1/n, up to the highest degree
template <class T>
constexpr std::array<T, 21> kInverse = [] {
  std::array<T, 21> inverse{};
  for (int n = 1; n <= 20; ++n) inverse[static_cast<std::size_t>(n)] = T(1) / T(n);
  return inverse;
}();

/// The rotation matrix of a unit quaternion with products of its components xx = (x x, x y, x z,
/// x w) and so on; with series, the products are those of series and `one` is that of 1.
template <class T>
inline void setRotationMatrix(T one, const Array4<T>& x, const Array4<T>& y, const Array4<T>& z,
                              Matrix3<T>& R) {
  R(0, 0) = one - T(2) * (y[1] + z[2]);
  R(0, 1) = T(2) * (x[1] - z[3]);
  R(0, 2) = T(2) * (x[2] + y[3]);
  R(1, 0) = T(2) * (x[1] + z[3]);
  R(1, 1) = one - T(2) * (x[0] + z[2]);
  R(1, 2) = T(2) * (y[2] - x[3]);
  R(2, 0) = T(2) * (x[2] - y[3]);
  R(2, 1) = T(2) * (y[2] + x[3]);
  R(2, 2) = one - T(2) * (x[0] + y[1]);
}

/// Σ (R armᵢ) × forceᵢ from moments = Σ armᵢ forceᵢᵀ: twice the axial vector of R moments.
template <class T>
Vector3<T> turnedMoment(const Matrix3<T>& R, const Matrix3<T>& moments) {
  const auto element = [&](int i, int j) {
    return R(i, 0) * moments(0, j) + R(i, 1) * moments(1, j) + R(i, 2) * moments(2, j);
  };
  return Vector3<T>(element(1, 2) - element(2, 1), element(2, 0) - element(0, 2),
                    element(0, 1) - element(1, 0));
}

/// The power of two at or below a positive finite rate; 1 for a rate of zero. Scaling by it is
/// exact, so that the units of the scene change no digit, and nothing overflows on the way.
template <class T>
T unitOf(T rate) {
  if (!(rate > T(0))) return T(1);
  return std::ldexp(T(1), std::min(std::max(std::ilogb(rate), -1000), 1000));
}

/// The least degree n >= 7, up to the highest, at which angleⁿ is below rounding, angle being rate
/// × time. Measured: of random bodies and wrenches, 99 in 100 then last as long as was asked.
template <class T>
std::size_t degreeFor(T angle, std::size_t highest) {
  T term = T(1);
  for (std::size_t n = 1; n < highest; ++n) {
    term *= angle;
    if (n >= 7 && term <= std::numeric_limits<T>::epsilon()) return n;
  }
  return highest;
}

}  // namespace rigid_body_sim
