#pragma once

#include "dynamics/contact/contact_law.hpp"
#include "dynamics/contact/patch.hpp"

namespace rigid_body_sim {

/// Contact of one body with a half-space: a patch for each of its features.
class PlaneContact final : public ContactLaw {
 public:
  PlaneContact(const Body& on, std::size_t body, const std::vector<Feature>& features,
               const HalfSpace& plane, const ContactParameters& parameters);

  std::vector<std::size_t> members() const override { return {body_}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override;
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override;

  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override;
  void addWrenchesAndRates(const Bodies& at, std::vector<Wrench>& wrenches,
                           double* rates) const override;
  double potentialEnergy(const Bodies& at) const override;
  double externalPower(const Bodies& at) const override;
  double rate(const Bodies& at, const std::vector<double>& speeds) const override;
  double reach(const Bodies& at) const override;

  std::size_t stateCount() const override { return patches_.size() * Patch::kOwnCount; }
  bool admits(const double* own) const override;
  void setRates(const Bodies& at, double* rates) const override;
  std::size_t guardCount() const override { return guard_count_; }
  void setGuards(const Bodies& at, double* guards) const override;
  void switchMode(std::size_t guard, const Bodies& at, double* own) const override;
  bool acts(const double* own) const override;

  double quietInFlight(double t, const Bodies& at,
                       const std::vector<MotionBound>& bounds) const override;
  double longestStep(const Bodies& at, double precision) const override;
  bool holdsStill(const Bodies& at, const std::vector<Stray>& strays) const override;
  void addContacts(const Bodies& at, std::vector<ContactPoint>& contacts) const override;
  void addContactEvents(const Bodies& at, const double* before,
                        std::vector<ContactEvent>& events) const override;

  /// [m] How far a sphere about the centre of mass that holds all of it lies below the plane; not
  /// above zero where some of it may reach out.
  double buriedBy(const BodyState& state) const;

  /// The body of the plane, or kWorld.
  std::size_t planeBody() const { return plane_.half_space.body; }

 private:
  Patch::Pose poseOf(const Bodies& at) const {
    return {*at.bodies[body_], at.states[body_], plane_};
  }
  template <class Term>
  double sum(const Bodies& at, const Term& term) const;
  ContactPoint contactAt(const Patch::Pose& pose, const Patch& patch, const double* own) const;

  std::size_t body_;
  std::size_t label_;  // index of the body in the world
  Plane plane_;
  std::vector<Patch> patches_;
  std::size_t guard_count_ = 0;
  double reach_ = 0;  // [m] of all features
};

}  // namespace rigid_body_sim
