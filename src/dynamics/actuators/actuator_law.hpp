#pragma once

#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>

#include "dynamics/actuators/actuator_schedule.hpp"

namespace rigid_body_sim {

/// What integrators must support to advance a body with these actuators (Need).
unsigned needsOf(const ActuatorTable& table);

/// The actuators of one body between two events, as a law on its motion without wheels and rotors
/// (BodyState::L_P):
///   force R f,  torque τ + H × ω − H′,  L_P = I ω
/// Its own state is the time since drive().start, so that integrators take it as a function of time
/// at every stage. Its potential is what rotors and wheels have by themselves, Σ h²/2J + Σ ½ J Ω²;
/// the power of the rest of their energy, H·ω of the rotors, is couplingPower.
class ActuatorLaw final : public ForceLaw {
 public:
  ActuatorLaw(std::size_t body, const ActuatorSchedule& schedule);

  const ActuatorDrive& drive() const { return drive_; }
  std::size_t body() const { return body_; }

  const char* name() const override { return "motors"; }
  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  unsigned needs() const override { return needsOf(*table_); }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& at) const override;
  double externalPower(const Bodies& at) const override;
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;
  bool hasRate() const override { return true; }
  std::size_t stateCount() const override { return 1; }
  void setStart(double* own) const override { own[0] = 0; }
  void setRates(const Bodies& at, double* rates) const override;
  bool holdsStill(const Bodies&, const std::vector<Stray>&) const override {
    return drive_.isIdle();
  }

  /// [N m] The part of the torque that changes no angular momentum: H × ω − H′.
  Vector3d reactionOn(const Bodies& at) const;

  /// [N] Thrust on a body on a pivot, principal axes: what the pivot takes up.
  Vector3d onPivot(const Bodies& at) const;

  /// [W] d/dt (H·ω) of the rotors; w_dot_P [rad/s²]: the body's angular acceleration.
  double couplingPower(const Bodies& at, const Vector3d& w_dot_P) const;

 private:
  Vector3d angularVelocityOf(const Bodies& at) const;

  std::size_t body_;
  std::shared_ptr<const ActuatorTable> table_;
  std::vector<ActuatorState> states_;
  ActuatorDrive drive_;
};

}  // namespace rigid_body_sim
