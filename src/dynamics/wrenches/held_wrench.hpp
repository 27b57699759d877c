#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// The sum of the wrenches that act on one body between two events and depend on its own motion
/// only: however many there are, evaluation costs the same. Forces that cancel leave what they were
/// too great to hold: 1e20 N + 1 N − 1e20 N is 1 N. With R = R(q_WP):
///   force   f = f_W + R f_P
///   torque  τ = tau_W + R tau_P + R Σ armᵢ × Rᵀ forceᵢ + Σ (pointⱼ − x) × forceⱼ
struct HeldWrench {
  /// A force fixed in the world that acts at a point fixed in the body.
  struct Lever {
    Vector3d arm_P;                      ///< [m]
    Vector3d force_W;                    ///< [N], also part of f_W
    Vector3d lost_W = Vector3d::Zero();  ///< [N] what force_W is too coarse to hold
  };
  /// A force fixed in the world that acts at a point fixed in the world.
  struct Pull {
    Vector3d point_W;                    ///< [m]
    Vector3d force_W;                    ///< [N], also part of f_W
    Vector3d lost_W = Vector3d::Zero();  ///< [N]
  };

  Vector3d f_W = Vector3d::Zero();    ///< [N] forces fixed in the world, wherever they act
  Vector3d tau_W = Vector3d::Zero();  ///< [N m] couples fixed in the world
  Vector3d f_P = Vector3d::Zero();    ///< [N] forces fixed in the body
  Vector3d tau_P = Vector3d::Zero();  ///< [N m] couples and moments fixed in the body
  std::vector<Lever> levers;          ///< at most three: more are summed into one per world axis
  std::vector<Pull> pulls;            ///< at most three: more are summed into one and a couple

  /// Whether the wrench is of this kind: axes and point each fixed in the world or in the body
  /// itself, but not body axes at a world point.
  static bool holds(const PointWrench& applied);

  void add(const PointWrench& applied);

  /// The wrench at a state of the body.
  Wrench at(const BodyState& state) const;

  /// No force in body axes and no torque at all: the centre of mass flies a parabola and the
  /// attitude turns freely.
  bool torqueFree() const;

 private:
  void mergePulls();

  // what the sums above are too coarse to hold
  Vector3d f_lost_W_ = Vector3d::Zero();
  Vector3d tau_lost_W_ = Vector3d::Zero();
  Vector3d f_lost_P_ = Vector3d::Zero();
  Vector3d tau_lost_P_ = Vector3d::Zero();
};

}  // namespace rigid_body_sim
