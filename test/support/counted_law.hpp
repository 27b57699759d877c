#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim::test {

/// A law that counts how often it is asked.
class CountedLaw final : public ForceLaw {
 public:
  CountedLaw(std::shared_ptr<const ForceLaw> law, std::int64_t& count)
      : law_(std::move(law)), count_(count) {}
  const char* name() const override { return law_->name(); }
  std::vector<std::size_t> members() const override { return law_->members(); }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override {
    return std::make_shared<CountedLaw>(law_->reindexed(index), count_);
  }
  std::shared_ptr<const ForceLaw> reframed(std::size_t body, const Body& before,
                                           const Body& after) const override {
    return std::make_shared<CountedLaw>(law_->reframed(body, before, after), count_);
  }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override {
    ++count_;
    law_->addWrenches(at, wrenches);
  }
  double potentialEnergy(const Bodies& at) const override { return law_->potentialEnergy(at); }
  double externalPower(const Bodies& at) const override { return law_->externalPower(at); }
  unsigned needs() const override { return law_->needs(); }

 private:
  std::shared_ptr<const ForceLaw> law_;
  std::int64_t& count_;
};

}  // namespace rigid_body_sim::test
