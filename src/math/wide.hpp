#pragma once

namespace rigid_body_sim {

/// The scalar in which constants of T are worked out where their rounding is multiplied by a long
/// time: more digits and a wider exponent range than T, where the machine has such a type.
template <class T>
struct WideOf {
  using type = T;
};
template <>
struct WideOf<double> {
  using type = long double;
};
template <class T>
using Wide = typename WideOf<T>::type;

/// π to the digits of a 128-bit long double.
template <class T>
constexpr T kPi = T(3.14159265358979323846264338327950288L);

}  // namespace rigid_body_sim
