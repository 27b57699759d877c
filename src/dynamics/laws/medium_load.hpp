#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Of |u|: what a component of u is taken for zero up to. Turning u into the axes of the drag
/// leaves 1e-16 of it, of any sign, where the component is zero; and the error of taking so small a
/// component's sign for the other, 1e-24 of the drag, is below rounding.
constexpr double kZeroShare = 1e-12;

/// What a medium exerts on one body, summed over its laws, in the terms in which it is solved:
/// with u the velocity through the medium of the centre of drag, u_i its components in the axes of
/// the drag, A the attitude Rᵀ,
///   f_P = −linear u − quadratic |u| u − R_PD (quadratic_axes_i |u_i| u_i) + A lift_W
///   τ_P = center × drag + lift_arm × A lift_W − angular ω
struct MediumLoad {
  Vector3d velocity_W = Vector3d::Zero();      ///< [m/s] of the medium
  Vector3d center_P = Vector3d::Zero();        ///< [m] of drag, from the centre of mass
  double linear = 0;                           ///< [N s/m] alike in every direction
  Matrix3d linear_P = Matrix3d::Zero();        ///< [N s/m] beyond that
  double quadratic = 0;                        ///< [N s²/m²] alike in every direction
  Vector3d quadratic_axes = Vector3d::Zero();  ///< [N s²/m²]
  Matrix3d R_PD = Matrix3d::Identity();        ///< axes of the drag in principal axes
  Matrix3d angular_P = Matrix3d::Zero();       ///< [N m s]
  Vector3d lift_W = Vector3d::Zero();          ///< [N] of buoyancy
  Vector3d lift_arm_P = Vector3d::Zero();      ///< [m] where it acts

  bool any() const {
    return linear != 0 || quadratic != 0 || !linear_P.isZero(0) || !quadratic_axes.isZero(0) ||
           !angular_P.isZero(0) || !lift_W.isZero(0);
  }

  /// Whether drag depends on the velocity of the centre of mass in the world alone.
  bool isOfTranslation() const {
    return center_P.isZero(0) && linear_P.isZero(0) && quadratic_axes.isZero(0);
  }
};

}  // namespace rigid_body_sim
