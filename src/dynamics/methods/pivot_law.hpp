#pragma once

#include <vector>

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// The force of pivots, as a law on the bodies on them: whatever acts on such a body by then, the
/// pivot holds its point in place. It comes after all other laws with a force:
///   f = −Σ f,   τ = 0 about the pivot
/// Since it has no states of its own, nothing of it is saved.
class PivotLaw final : public ForceLaw {
 public:
  explicit PivotLaw(const std::vector<System::Pivot>& pivots);

  const char* name() const override { return "pivot"; }
  std::vector<std::size_t> members() const override { return bodies_; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  unsigned needs() const override { return 0; }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  double potentialEnergy(const Bodies&) const override { return 0; }
  double externalPower(const Bodies&) const override { return 0; }

 private:
  std::vector<std::size_t> bodies_;
};

/// What is held on a body on a pivot, with gravity at its centre of mass: torques about the pivot
/// and no force. Leaves the forces in pivot.
HeldWrench heldOnPivot(const Body& body, HeldWrenchSum wrenches, System::Pivot& pivot);

/// [N] All forces but the pivot's on each body of system.pivots, gravity included.
std::vector<Vector3d> forcesOnPivoted(const System& system, const SystemState& states);

}  // namespace rigid_body_sim
