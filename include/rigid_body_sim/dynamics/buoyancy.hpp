#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Lift of a medium that is everywhere around one body, under uniform gravity g: with ρ V the mass
/// of the medium that the body displaces,
///   f = −ρ V g   at the centroid of its volume x_b,   V_pot = ρ V g · x_b.
class Buoyancy final : public ForceLaw {
 public:
  /// displaced [kg] = ρ V >= 0; centroid_P [m] in principal axes. Throws std::invalid_argument.
  Buoyancy(std::size_t body, double displaced, const Vector3d& centroid_P, const Vector3d& g_W);

  const char* name() const override { return "buoyancy"; }
  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;
  unsigned needs() const override { return kCoupling; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies& at) const override;
  double externalPower(const Bodies& /*at*/) const override { return 0; }
  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override;
  bool isOfMedium() const override { return true; }
  void addMedium(const Bodies& at, MediumLoad& load) const override;

 private:
  std::size_t body_;
  double displaced_;  // [kg]
  Vector3d centroid_P_, g_W_;
};

}  // namespace rigid_body_sim
