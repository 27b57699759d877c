#pragma once

#include "dynamics/run/exchange_meter.hpp"
#include "math/compensated_sum.hpp"

namespace rigid_body_sim {

/// The books of a run since a start: what the bodies had, and what they exchanged since. What they
/// have beyond that, no law of motion explains: it is the integrator's error.
class Balance {
 public:
  Balance(const World& world, const State& start) : start_(totalsOf(world, start)) {}

  /// To meter a step with, from its start.
  ExchangeMeter& beginStep();

  /// Books what the meter has seen, once the step is done.
  void endStep();

  /// Books what bodies have more once their mass properties have been set. Their momenta are kept
  /// and not booked, but where a pivot takes up the change.
  void addChange(const Totals& before, const Totals& after, bool with_momenta);

  /// Work [J], impulse and angular impulse since the start.
  Totals exchanged() const;

  /// E − E₀ − work,   p − p₀ − ∫f,   L − L₀ − ∫τ
  Totals remainder(const World& world, const State& now) const;

 private:
  Totals start_;
  ExchangeMeter meter_;
  CompensatedSum<double> work_{0};
  CompensatedSum<Vector3d> impulse_{Vector3d::Zero()};
  CompensatedSum<Vector3d> angular_impulse_{Vector3d::Zero()};
};

}  // namespace rigid_body_sim
