#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <rigid_body_sim/math/types.hpp>

#include "dynamics/taylor/taylor_equations.hpp"

/// What the recursion of the Taylor segment is written in.
namespace rigid_body_sim {

/// 1/n, up to the highest degree and one more
template <class T>
constexpr std::array<T, kHighestTaylorDegree + 2> kInverse = [] {
  std::array<T, kHighestTaylorDegree + 2> inverse{};
  for (std::size_t n = 1; n < inverse.size(); ++n) inverse[n] = T(1) / T(n);
  return inverse;
}();

/// The rotation matrix of a unit quaternion from products of its components: (xx, yy, zz),
/// (xy, yz, zx) and (wx, wy, wz). With a series, or its integral, `one` is that of 1.
template <class T, class Lanes>
void setRotationMatrix(T one, const Lanes& squares, const Lanes& crosses, const Lanes& turns,
                       Matrix3<T>& R) {
  R(0, 0) = one - T(2) * (squares[1] + squares[2]);
  R(1, 1) = one - T(2) * (squares[0] + squares[2]);
  R(2, 2) = one - T(2) * (squares[0] + squares[1]);
  R(0, 1) = T(2) * (crosses[0] - turns[2]);
  R(1, 0) = T(2) * (crosses[0] + turns[2]);
  R(1, 2) = T(2) * (crosses[1] - turns[0]);
  R(2, 1) = T(2) * (crosses[1] + turns[0]);
  R(2, 0) = T(2) * (crosses[2] - turns[1]);
  R(0, 2) = T(2) * (crosses[2] + turns[1]);
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
  if constexpr (std::is_same_v<T, double>) {  // of most numbers the bits without the fraction
    constexpr double kSmall = 0x1p-1000, kLarge = 0x1p1000;
    if (kSmall <= rate && rate <= kLarge) {
      std::uint64_t bits;
      std::memcpy(&bits, &rate, sizeof bits);
      bits &= ~((std::uint64_t(1) << 52) - 1);
      std::memcpy(&rate, &bits, sizeof bits);
      return rate;
    }
  }
  return std::ldexp(T(1), std::min(std::max(std::ilogb(rate), -1000), 1000));
}

/// The share of a bound on the attitude's error [rad] that each radian of a run may take: the run
/// turns by theta, and an error of the angular velocity grows to up to theta times as much in the
/// attitude by its end.
template <class T>
T shareOf(T bound, T theta) {
  theta = std::max(T(1), theta);
  return bound / (T(20) * theta * theta);
}

/// The degree of the series: that of the best step (Jorba and Zou), −½ ln(precision), and a few
/// terms more, since a segment costs something whatever its degree; or, where that is less, the
/// least n >= 7 at which angleⁿ is below the precision, angle being rate × time. Measured: of
/// random bodies and wrenches, 99 in 100 then last as long as was asked.
template <class T>
std::size_t degreeFor(T angle, T precision, std::size_t highest) {
  std::size_t most = highest;
  if (precision > std::exp(T(12) - T(2) * T(highest))) {  // else the best is more
    const T best = std::ceil(T(6) - std::log(precision) / 2);
    most = static_cast<std::size_t>(std::min(std::max(best, T(7)), T(highest)));
  }
  if (!(angle < T(1))) return most;
  T term = T(1);
  for (std::size_t n = 1; n < most; ++n) {
    term *= angle;
    if (n >= 7 && term <= precision) return n;
  }
  return most;
}

}  // namespace rigid_body_sim
