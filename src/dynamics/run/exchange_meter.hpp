#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/totals.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/run/solved_motion.hpp"

namespace rigid_body_sim {

/// Sums what bodies exchange with what is around them while they are advanced:
///   work: ∫ Σ (f · v + τ · ω) dt of applied wrenches and drag, and ∫ externalPower dt of the laws,
///     which is all that no potential energy accounts for
///   impulse: ∫ Σ f dt of all forces, gravity and laws included
///   angular impulse: ∫ Σ (x × f + τ) dt likewise, about the world's origin
///
/// Each by a Gauss–Legendre rule over each part that the motion is advanced in. Between a start and
/// an end of a part, a stepped motion is where a shorter step of the same row leads to. With a node
/// more than half the order of the row, rounded down, the rule is of a higher order than the row:
/// what then is left of a balance is the row's doing. A decay that a step does not resolve (stiff
/// drag under a row that follows it by its own flow) is not resolved by the rule either.
class ExchangeMeter {
 public:
  /// Adds what is exchanged in a step of h [s] that the method is about to take.
  void step(const Method& method, const System& system, double h,
            const std::vector<BodyState>& start);

  /// Adds what one body exchanges from t to t_end, both within what its solution holds for.
  void solved(const System& system, const SolvedMotion& motion, double t, double t_end);

  /// Since it was made or last taken. Not numbers where a part of a step could not be followed.
  Totals take();

 private:
  void solve(const System& system, double h, const BodyState& start);
  void add(double weight, const System& system);

  Totals sum_;
  std::vector<BodyState> states_;  // at a node
  Workspace workspace_;
};

}  // namespace rigid_body_sim
