#pragma once

#include <memory>
#include <utility>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// A law of which a body is absent: it has the states of the law, and never acts.
class RestingLaw final : public ForceLaw {
 public:
  explicit RestingLaw(std::shared_ptr<const ForceLaw> law) : law_(std::move(law)) {}

  const char* name() const override { return law_->name(); }
  std::vector<std::size_t> members() const override { return law_->members(); }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override {
    return std::make_shared<RestingLaw>(law_->reindexed(index));
  }
  unsigned needs() const override { return 0; }
  void addWrenches(const Bodies& /*at*/, std::vector<Wrench>& /*wrenches*/) const override {}
  double potentialEnergy(const Bodies& /*at*/) const override { return 0; }
  double externalPower(const Bodies& /*at*/) const override { return 0; }
  std::size_t stateCount() const override { return law_->stateCount(); }
  void setStart(double* own) const override { law_->setStart(own); }
  bool admits(const double* own) const override { return law_->admits(own); }
  bool acts(const double* /*own*/) const override { return false; }
  bool setMedium(const Vector3d& velocity_W, double* own) const override {
    return law_->setMedium(velocity_W, own);
  }

 private:
  std::shared_ptr<const ForceLaw> law_;
};

}  // namespace rigid_body_sim
