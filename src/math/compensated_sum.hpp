#pragma once

#include "math/two_sum.hpp"

namespace rigid_body_sim {

/// Sum of many terms that carries what each addition rounds away: the result has the error of one
/// rounding (plus n² ulp² of the sum of magnitudes), so the order of the terms does not show.
/// T: double or an Eigen matrix of fixed size, summed coefficient by coefficient.
/// Source: Knuth, TAOCP 2, 4.2.2, theorem B; Ogita, Rump & Oishi 2005, Sum2.
template <class T>
class CompensatedSum {
 public:
  explicit CompensatedSum(const T& zero) : sum_(zero), lost_(zero) {}

  void add(const T& term) {
    T rounded_away;
    sum_ = twoSum(sum_, term, rounded_away);
    lost_ += rounded_away;
  }

  T value() const { return sum_ + lost_; }

 private:
  T sum_;
  T lost_;
};

}  // namespace rigid_body_sim
