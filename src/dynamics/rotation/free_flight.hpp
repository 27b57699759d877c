#pragma once

#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/rotation/free_top.hpp"

namespace rigid_body_sim {

/// The state of a body without any force dt [s] after a start, to rounding as by FreeFlight, which
/// does too much for one evaluation.
BodyState flownFreely(const Body& body, const BodyState& start, double dt);

/// The motion of a body without torque under a constant force fixed in the world, from a start on:
/// a parabola and the exact free rotation. Any time is one evaluation, nothing accumulates.
///   x = x₀ + (p₀/m) t + (f/m) t²/2,   p = p₀ + f t,   L = L₀
class FreeFlight {
 public:
  /// f_W [N]: gravity included. start.q_WP must be a unit quaternion. read_once: see FreeTop::from.
  FreeFlight(const Body& body, const Vector3d& f_W, const BodyState& start, bool read_once = false);

  const BodyState& start() const { return start_; }
  const Vector3d& force() const { return f_W_; }  ///< [N]
  double mass() const { return mass_; }           ///< [kg]
  const FreeRotation<double>& rotation() const { return rotation_; }

  /// The state dt [s] after the start.
  BodyState at(double dt) const;

 private:
  BodyState start_;
  Vector3d f_W_;
  double mass_;
  FreeRotation<double> rotation_;
};

}  // namespace rigid_body_sim
