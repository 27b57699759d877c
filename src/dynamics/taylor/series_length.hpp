#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

/// How far truncated series hold.
namespace rigid_body_sim {

/// x to the power 1/n, to some 13 digits; 0 and infinity stay.
template <class T>
T nthRoot(T x, std::size_t n) {
  return std::exp2(std::log2(x) / T(n));
}

/// Up to where a term of a degree is below a precision of a size; any length if it is zero. By
/// logarithms: the quotient of the sizes may be no number.
template <class T>
T lengthByTerm(T term, std::size_t degree, T precision, T size) {
  if (!(term > T(0))) return std::numeric_limits<T>::infinity();
  return std::exp((std::log(precision) + std::log(size) - std::log(term)) / T(degree));
}

/// The length of a series whose last two terms are zero, by those before. It ends there only up to
/// the degree that a motion can have which is a polynomial: a force at a point of the world turns a
/// body with the cube of time. Beyond, the others vanish by symmetry (a body that turns with the
/// cube of time has every third) or by underflow, and the last that is there counts. Of a low
/// degree it may be either: underflow hides less than the smallest normal number, and what it
/// shortened so much shrinks from term to term.
template <class SizeOf, class T>
T lengthByEarlier(const SizeOf& sizeOf, std::size_t degree, T precision, T own) {
  constexpr std::size_t kPolynomial = 4;
  std::size_t m = degree - 2;
  while (m > 0 && !(sizeOf(m) > T(0))) --m;
  if (m == 0) return std::numeric_limits<T>::infinity();
  const T by_term = lengthByTerm(T(sizeOf(m)), m, precision, own);
  if (m > kPolynomial) return by_term;
  return std::max(by_term, lengthByTerm(std::numeric_limits<T>::min(), m + 1, precision, own));
}

}  // namespace rigid_body_sim
