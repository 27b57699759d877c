#pragma once

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// The translation of a body under a constant acceleration a and linear drag alike in every
/// direction at the centre of mass, in closed form, however stiff the drag is. With the velocity u
/// through the medium, which moves at w, and k = linear/m:
///   u = e^(−kt) u₀ + t φ₁(kt) a,   x = x₀ + w t + t φ₁(kt) u₀ + t² φ₂(kt) a,
///   φ₁(z) = (1 − e^(−z))/z,   φ₂(z) = (1 − φ₁(z))/z.
/// Where there is little decay, by what is added to v₀ and v₀ t, as little of w comes to act:
///   v = v₀ − (1 − e^(−kt)) u₀ + t φ₁(kt) a,   x = x₀ + v₀ t − k t² φ₂(kt) u₀ + t² φ₂(kt) a.
class LinearTranslation {
 public:
  /// mass [kg], rate k [1/s], a_W [m/s²], medium_W [m/s] the velocity of the medium.
  LinearTranslation(double mass, double rate, const Vector3d& a_W, const Vector3d& medium_W)
      : mass_(mass), rate_(rate), a_W_(a_W), medium_W_(medium_W) {}

  /// Moves the translation of a state on by dt [s] from the start.
  void move(const BodyState& start, double dt, BodyState& state) const;

  /// [s] From dt on, over which what follows from the motion is integrated to rounding by a
  /// Gauss-Legendre rule of seven nodes: a short share of the decay, as long as there is any.
  double smoothFor(const BodyState& start, double dt) const;

 private:
  Vector3d velocityThrough(const BodyState& start) const { return start.p_W / mass_ - medium_W_; }

  double mass_, rate_;
  Vector3d a_W_, medium_W_;
};

}  // namespace rigid_body_sim
