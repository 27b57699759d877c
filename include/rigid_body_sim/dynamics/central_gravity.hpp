#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Gravity of a point mass at a place of the world, on one body: with r from the place to the
/// centre of mass,
///   f = −mu m r/|r|³,   V = −mu m/|r|,
/// and with the gradient also the torque of the uneven pull on a long body,
///   τ = 3 mu/|r|⁵ r × (I r),   I of the whole body, its wheels included.
/// The force that belongs to that torque is smaller than f by (size of the body/|r|)² and left out,
/// so that the torque has no potential: its power counts as external.
class CentralGravity final : public ForceLaw {
 public:
  /// center_W [m]; mu [m³/s²] > 0: gravitational constant × mass at the centre; all finite. Throws
  /// std::invalid_argument.
  CentralGravity(std::size_t body, const Vector3d& center_W, double mu, bool gradient);

  const char* name() const override { return "central gravity"; }
  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;
  unsigned needs() const override { return kCoupling; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& at) const override;
  double externalPower(const Bodies& at) const override;

  /// √(mu/r³), that of a circular orbit; with the gradient √3 times that, at which a rod swings.
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;

  bool hasRate() const override { return true; }

  const GravityCenter* gravityCenter() const override { return &gravity_; }

  /// The distance from the centre.
  double reach(const Bodies& at) const override { return radius(at.states[body_]).norm(); }

 private:
  Vector3d radius(const BodyState& state) const;
  Vector3d gradientTorque(const Body& body, const BodyState& state) const;  // principal axes

  std::size_t body_;
  GravityCenter gravity_;
  bool gradient_;
};

}  // namespace rigid_body_sim
