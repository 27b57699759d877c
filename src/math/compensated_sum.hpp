#pragma once

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
    const T sum = sum_ + term;
    const T kept = sum - sum_;
    lost_ += (sum_ - (sum - kept)) + (term - kept);
    sum_ = sum;
  }

  T value() const { return sum_ + lost_; }

 private:
  T sum_;
  T lost_;
};

}  // namespace rigid_body_sim
