#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Resistance of a medium at rest on one body, with v the velocity of its centre of mass:
///   f = −(linear + quadratic |v|) v,   τ = −angular ω
class Drag final : public ForceLaw {
 public:
  struct Coefficients {
    double linear = 0;     ///< [N s/m] >= 0
    double quadratic = 0;  ///< [N s²/m²] >= 0
    double angular = 0;    ///< [N m s] >= 0

    bool any() const { return linear != 0 || quadratic != 0 || angular != 0; }
  };

  /// Throws std::invalid_argument for coefficients that break a rule.
  Drag(std::size_t body, const Coefficients& coefficients);

  const char* name() const override { return "drag"; }
  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;
  unsigned needs() const override { return kDrag; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& /*at*/) const override { return 0; }

  /// −((linear + quadratic |v|) v² + angular ω²)
  double externalPower(const Bodies& at) const override;

  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override;

  /// (linear + 2 quadratic |v|)/m at the given speed, where drag is quadratic.
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;

  bool hasRate() const override { return coefficients_.quadratic != 0; }
  bool rateGrowsWithSpeed() const override { return coefficients_.quadratic != 0; }

  bool hasKink() const override { return coefficients_.quadratic != 0; }
  double distanceToKink(const Bodies& at, const std::vector<BodyMotion>& motions, double h,
                        double negligible) const override;

  bool hasFlow() const override { return true; }

  /// p' = f − (linear + quadratic |p|/m) p/m,   L_P,i' = τ_P,i − angular L_P,i/I_i.
  /// The angular part is exact, and so is the linear; quadratic drag acts as linear drag of the
  /// mean speed of start and end, which is symmetric, of second order, and exact at the terminal
  /// velocity. h may be negative where there is no quadratic drag.
  void kick(const Body& body, const Wrench& wrench, double h, BodyState& state) const override;

  bool holdsStill(const Bodies& /*at*/, const std::vector<Stray>& /*strays*/) const override {
    return true;
  }

  bool isOfMedium() const override { return true; }
  void addMedium(const Bodies& at, MediumLoad& load) const override;

  const Coefficients& coefficients() const { return coefficients_; }

 private:
  std::size_t body_;
  Coefficients coefficients_;
};

}  // namespace rigid_body_sim
