#pragma once

#include <string>
#include <vector>

#include "trade_errors.hpp"

namespace rigid_body_sim {

/// The motion that settings are held against, computed in two independent ways.
struct Reference {
  std::vector<State> states;  ///< at equal intervals, the first the initial state
  double duration = 0;        ///< [s] until the last
  std::string method;         ///< what computed the states
  std::string check;          ///< what else agrees with them
  Errors doubt;               ///< the greatest differences between the two
};

/// The motion over a duration [s]: solved where every body permits it, checked by dop853; else by
/// dop853, checked by kahan_li8, or by rk4 where there is damping. A row is taken in shorter and
/// shorter steps until it gains no more. Throws SimulationDiverged where none of the steps goes
/// through.
Reference computeReference(const World& world, const State& initial, double duration);

}  // namespace rigid_body_sim
