#pragma once

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// A cubic through the states at both ends of a substep, and their rates there, which the
/// integrator's first and last stage have left: near enough to tell where to look for an event, at
/// none of the cost of a shorter substep.
class CubicBetween {
 public:
  /// Must not outlive what it is made of. stages: of the substep of h [s] from a to b.
  CubicBetween(const SystemState& a, const SystemState& b, const Workspace& stages, double h)
      : a_(a), b_(b), stages_(stages), h_(h) {}

  /// The states at a share of the substep. L_W is that of R L_P.
  void at(double share, SystemState& states) const;

 private:
  const SystemState& a_;
  const SystemState& b_;
  const Workspace& stages_;
  double h_;
};

}  // namespace rigid_body_sim
