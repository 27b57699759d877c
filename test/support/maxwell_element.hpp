#pragma once

#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "support/worlds.hpp"

namespace rigid_body_sim::test {

/// A spring and a dashpot in series that hold body 0 to the world's origin along x. The dashpot's
/// length s [m] is a state of the law:
///   f = −k (x − s),   s' = k (x − s)/c
class MaxwellElement final : public ForceLaw {
 public:
  static constexpr double k = 30;  ///< [N/m]
  static constexpr double c = 6;   ///< [N s/m]

  const char* name() const override { return "Maxwell element"; }
  std::vector<std::size_t> members() const override { return {0}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>&) const override {
    return std::make_shared<MaxwellElement>();
  }
  unsigned needs() const override { return kCoupling | kLawStates; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override {
    wrenches[0].f_W.x() -= tension(at);
  }
  double potentialEnergy(const Bodies& at) const override {
    return 0.5 * tension(at) * tension(at) / k;
  }
  double externalPower(const Bodies& at) const override { return -tension(at) * tension(at) / c; }
  std::size_t stateCount() const override { return 1; }
  void setRates(const Bodies& at, double* rates) const override { rates[0] = tension(at) / c; }

 private:
  static double tension(const Bodies& at) {
    const BodyState& s = at.states[0];
    return k * (s.x_W.x() + s.x_low_W.x() - at.own[0]);
  }
};

inline Bench maxwellBench() {
  Bench bench;
  bench.add(principalBody("ball", 2, {0.1, 0.1, 0.1}), tumbling({3, 0, 0}, {0, 0, 0}));
  bench.world.laws.push_back(std::make_shared<MaxwellElement>());
  return bench;
}

/// x at t, from 0 at 3 m/s with 2 kg: with e = x − s, e' = v − k e/c and v' = −k e/m, so that e is
/// a damped oscillation and x = ∫ v, v = e' + k e/c.
inline double maxwellPosition(double t) {
  constexpr double m = 2, v = 3, k = MaxwellElement::k, c = MaxwellElement::c;
  const std::complex<double> root =
      -k / (2 * c) + std::sqrt(std::complex<double>(k * k / (4 * c * c) - k / m));
  // e = a exp(root t) + conjugate, e(0) = 0, e'(0) = v
  const std::complex<double> a = v / (std::complex<double>(0, 2) * root.imag());
  const std::complex<double> e = a * std::exp(root * t), e_0 = a;
  const std::complex<double> integral = (e - e_0) / root;
  return 2 * (e - e_0).real() + k / c * 2 * integral.real();
}

}  // namespace rigid_body_sim::test
