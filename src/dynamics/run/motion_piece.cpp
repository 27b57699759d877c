#include "dynamics/run/motion_piece.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/actuators/actuator_law.hpp"
#include "math/gauss_legendre.hpp"

namespace rigid_body_sim {

MotionPiece::MotionPiece(const System& system, const SolvedMotion& motion,
                         const std::vector<double>& laws, double start, double end)
    : system_(system), motion_(&motion), laws_(&laws), start_(start), end_(end) {}

MotionPiece::MotionPiece(const System& system, const Method& method, const SystemState& at_start,
                         double start, double end, Workspace& scratch)
    : system_(system),
      method_(&method),
      at_start_(&at_start),
      scratch_(&scratch),
      start_(start),
      end_(end) {}

void MotionPiece::at(double t, SystemState& states) const {
  if (motion_) {
    states.bodies.resize(1);
    states.bodies[0] = motion_->at(t);
    states.laws = *laws_;
    for (const System::Driven& driven : system_.driven)
      states.laws[driven.state] = t - driven.law->drive().start;
    return;
  }
  states = *at_start_;
  scratch_->wrenches_current = false;
  takeStep(*method_, system_, t - start_, states, *scratch_);
}

/// A solution: nodes that integrate to rounding over a share of the time that it holds for. A free
/// flight, which holds for ever, brings integrands quadratic in time at most: two nodes. A Taylor
/// series of degree N to rounding ε holds for at most ε^(1/N) = 1/6 of its radius of convergence
/// (N = 20). Where the integrand is analytic up to there, the rule's error falls by
/// r² >= (22/share)² a node: r is the sum of the half axes of the ellipse with foci at both ends
/// that reaches the nearest singularity. Series to a looser tolerance reach further; there the rule
/// errs by less than they do. Source: Trefethen, SIAM Review 50 (2008) 67, theorem 4.5. An
/// exponential decay has no singularity, and holds longer than such a rule sees it.
///
/// A substep: a node more than half the order, rounded down, so that the rule is of a higher order
/// than the integrator.
int MotionPiece::gaussNodes() const {
  if (method_) return method_->order / 2 + 1;
  constexpr double kDigits = 18;
  const double share = (end_ - start_) / (motion_->smoothUntil(start_) - start_);
  const double digits_a_node = 2 * std::log10(22 / std::max(share, 1e-12));
  return std::clamp(static_cast<int>(std::ceil(kDigits / digits_a_node)), 2, kMaxGaussNodes);
}

}  // namespace rigid_body_sim
