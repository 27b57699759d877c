#pragma once

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// How far a body is taken to move and turn from a state within a time, at most. Where that is not
/// known beforehand, it is watched: what is left of it then is room for another substep.
struct Roam {
  BodyState from;
  double place = 0;  ///< [m]
  double turn = 0;   ///< [rad]

  bool isNearlyUsedUp(const BodyState& now) const {
    constexpr double kShare = 0.7;
    return !(distanceBetween(from, now) <= kShare * place) ||
           !(angleBetween(from.q_WP, now.q_WP) <= kShare * turn);
  }
};

}  // namespace rigid_body_sim
