#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tools/trade/trade_errors.hpp"

namespace rigid_body_sim {

/// The motion that settings are compared with, computed in two independent ways.
struct Reference {
  std::vector<State> states;  ///< at equal intervals, the first the initial state
  double duration = 0;        ///< [s] until the last
  std::string method;         ///< what computed the states
  std::string check;          ///< what else agrees with them
  Errors doubt;               ///< the greatest differences between the two
  double known_until = std::numeric_limits<double>::infinity();  ///< [s] of chaotic motions
};

/// The motion over a duration [s]. Where nothing acts but gravity: the exact rotation in long
/// double, checked by Taylor series. Where nothing couples the bodies and nothing resists them:
/// Taylor series in long double, checked by dop853. Else dop853, checked by kahan_li8 or, where
/// there is drag or damping, by rk4. Steps are made shorter until the run gains no
/// more. Throws SimulationDiverged where none of the steps goes through, and StepTooLong.
/// Not for worlds with contact; see contactReference.
Reference computeReference(const World& world, const State& initial, double duration);

}  // namespace rigid_body_sim
