#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Resistance of a medium that moves at the velocity w, on a point of one body: with c the point
/// from the origin of P, u = v + ω × c − w its velocity through the medium, u_i its components
/// in the axes of the drag,
///   f = −(linear + quadratic |u|) u − Σ (linear_i + quadratic_i |u_i|) u_i e_i   at the point,
///   τ = −angular ω − Σ angular_i ω_i e_i
/// A key with one value resists alike in every direction, one with three along each axis.
///
/// Its states are the velocity of the medium in world axes, which may be set from outside, and the
/// signs of the u_i, by which the changes of sign are events: u_i² has a kink in them.
class MediumDrag final : public ForceLaw {
 public:
  /// Alike in every direction, and along each axis; all >= 0.
  struct Key {
    double alike = 0;
    Vector3d axes = Vector3d::Zero();

    bool any() const { return alike != 0 || !axes.isZero(0); }
  };
  struct Coefficients {
    Key linear;                            ///< [N s/m]
    Key quadratic;                         ///< [N s²/m²]
    Key angular;                           ///< [N m s]
    Vector3d center_P = Vector3d::Zero();  ///< [m] c, principal axes
    Matrix3d R_PD = Matrix3d::Identity();  ///< the axes of the drag, in principal axes

    bool any() const { return linear.any() || quadratic.any() || angular.any(); }
  };

  /// medium_W [m/s]: w at the start. Throws std::invalid_argument for what breaks a rule.
  MediumDrag(std::size_t body, const Coefficients& coefficients, const Vector3d& medium_W);

  const char* name() const override { return "drag"; }
  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;
  unsigned needs() const override { return kCoupling | kDamping; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& /*at*/) const override { return 0; }

  /// f · (v + ω × c) + τ · ω, of either sign: wind does work.
  double externalPower(const Bodies& at) const override;

  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override;

  /// What quadratic drag adds to the decay, at the given speed and that of the medium.
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;
  bool hasRate() const override { return coefficients_.quadratic.any(); }
  bool rateGrowsWithSpeed() const override { return coefficients_.quadratic.any(); }

  /// Of what is alike in every direction; those along the axes are events.
  bool hasKink() const override { return coefficients_.quadratic.alike != 0; }
  double distanceToKink(const Bodies& at, const std::vector<BodyMotion>& motions, double h,
                        double negligible) const override;

  std::size_t stateCount() const override { return 6; }
  void setStart(double* own) const override;
  bool admits(const double* own) const override;
  std::size_t guardCount() const override { return coefficients_.quadratic.axes.isZero(0) ? 0 : 3; }
  void setGuards(const Bodies& at, double* guards) const override;
  void switchMode(std::size_t guard, const Bodies& at, double* own) const override;

  bool setMedium(const Vector3d& velocity_W, double* own) const override;
  bool isOfMedium() const override { return true; }
  void addMedium(const Bodies& at, MediumLoad& load) const override;

  const Coefficients& coefficients() const { return coefficients_; }

 private:
  Vector3d throughMedium(const Bodies& at) const;

  std::size_t body_;
  Coefficients coefficients_;
  Vector3d medium_W_;
};

}  // namespace rigid_body_sim
