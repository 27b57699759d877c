#pragma once

#include "dynamics/contact/feature.hpp"
#include "dynamics/laws/turning_bound.hpp"

namespace rigid_body_sim {

/// The first root after 0 of gap + speed τ + ½ acceleration τ², of gap >= 0, acceleration <= 0;
/// infinity where there is none.
double firstRoot(double gap, double speed, double acceleration);

/// A lower bound on the gap between a body in flight and a plane: with m = −Rᵀ n, m' = m × ω, h the
/// support function, a the acceleration and x the centre of mass,
///   gap(τ) >= n · (x + v τ + ½ a τ²) − h(m + τ m') − ½ B τ²,   B = (|α| + ω²) reach + |a| off,
/// since the body turns out of m + τ m' by at most ½ (|α| + ω²) τ². It is concave in τ where a does
/// not lead away from the plane; there a is left out.
class PlaneFlight {
 public:
  PlaneFlight(const Body& body, const BodyState& state, const HalfSpace& plane,
              const MotionBound& bound);

  /// [s] For how long a feature cannot touch the plane, at least.
  double clearFor(const Feature& feature) const;

  /// [s] The same of everything within `reach` [m] of the centre of mass: coarser, and quicker.
  /// Zero unless that is as far away again.
  double clearFor(double reach) const;

 private:
  double height_, low_;  // [m] of the centre of mass above the plane, in two parts
  double speed_;         // [m/s] away from the plane
  double acceleration_;  // [m/s²] the least away from the plane; at most zero
  double turning_;       // [1/s²]
  double horizon_;       // [s] for how long all this holds
  Vector3d m_P_, m_dot_P_;
};

}  // namespace rigid_body_sim
