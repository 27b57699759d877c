#pragma once

namespace rigid_body_sim {

/// a + b rounded, and what the rounding takes away, exactly.
/// T: double or an Eigen matrix of fixed size, coefficient by coefficient.
/// Source: Knuth, TAOCP 2, 4.2.2, theorem B.
template <class T>
inline T twoSum(const T& a, const T& b, T& rounded_away) {
  T sum = a + b;
  const T kept = sum - a;
  rounded_away = (a - (sum - kept)) + (b - kept);
  return sum;
}

}  // namespace rigid_body_sim
