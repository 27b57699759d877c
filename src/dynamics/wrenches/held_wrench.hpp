#pragma once

#include <array>
#include <map>
#include <vector>

#include <rigid_body_sim/dynamics/wrench.hpp>

#include "dynamics/actuators/actuator_drive.hpp"

namespace rigid_body_sim {

struct MediumLoad;

/// The sum of the wrenches that act on one body between two events and depend on its own motion
/// only: however many there are, evaluation costs the same. With R = R(q_WP):
///   force   f = f_W + R f_P
///   torque  τ = tau_W + R tau_P + R Σ armᵢ × Rᵀ forceᵢ + Σ (pointⱼ − x) × forceⱼ
struct HeldWrench {
  /// A force fixed in the world that acts at a point fixed in the body. Where more than three are
  /// summed into one per world axis, the force is the axis, without unit, and the arm is a moment
  /// [N m].
  struct BodyPointForce {
    Vector3d arm_P;    ///< [m]
    Vector3d force_W;  ///< [N], also part of f_W
  };
  /// A force fixed in the world that acts at a point fixed in the world.
  struct WorldPointForce {
    Vector3d point_W;  ///< [m]
    Vector3d force_W;  ///< [N], also part of f_W
  };

  Vector3d f_W = Vector3d::Zero();                  ///< [N] forces fixed in the world
  Vector3d tau_W = Vector3d::Zero();                ///< [N m] couples fixed in the world
  Vector3d f_P = Vector3d::Zero();                  ///< [N] forces fixed in the body
  Vector3d tau_P = Vector3d::Zero();                ///< [N m] couples and moments fixed in the body
  std::vector<BodyPointForce> body_point_forces;    ///< at most three
  std::vector<WorldPointForce> world_point_forces;  ///< at most three

  bool is_zero = false;  ///< whether all of that is known to be zero

  /// What actuators add, which changes with time; null where they are idle. Not part of at().
  const ActuatorDrive* drive = nullptr;

  /// What a medium exerts on the body, where it is solved for; kept by the system. at() leaves it
  /// out.
  const MediumLoad* medium = nullptr;

  /// Whether the wrench is of this kind: axes and point each fixed in the world or in the body
  /// itself, but not body axes at a world point.
  static bool holds(const PointWrench& applied);

  /// The wrench at a state of the body.
  Wrench at(const BodyState& state) const;

  /// No force in body axes, no torque and no drive at all: the centre of mass flies a parabola and
  /// the attitude turns freely.
  bool torqueFree() const;
};

/// Sums wrenches that HeldWrench::holds on one body. Forces that cancel leave what they were too
/// great to hold: 1e20 N + 1 N − 1e20 N is 1 N, wherever they act and in whatever order.
class HeldWrenchSum {
 public:
  void add(const PointWrench& applied);
  HeldWrench sum() const;

 private:
  /// A vector and what it is too coarse to hold.
  struct Pair {
    Vector3d high = Vector3d::Zero();
    Vector3d low = Vector3d::Zero();
    void add(const Vector3d& term);
  };
  struct AtPlace {
    Vector3d place;
    Pair force_W;
  };
  /// Forces by the place at which they act, in the order of their first.
  class Places {
   public:
    void add(const Vector3d& place, const Vector3d& force_W);
    const std::vector<AtPlace>& forces() const { return forces_; }

   private:
    std::vector<AtPlace> forces_;
    std::map<std::array<double, 3>, std::size_t> index_;  // in forces_
  };
  std::vector<HeldWrench::BodyPointForce> bodyPointForces() const;
  std::vector<HeldWrench::WorldPointForce> worldPointForces(Pair& tau_W) const;

  Pair f_W_, tau_W_, f_P_, tau_P_;
  Places on_body_, in_world_;
};

}  // namespace rigid_body_sim
