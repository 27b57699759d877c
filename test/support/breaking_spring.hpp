#pragma once

#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/spring.hpp>

/// Laws with modes, in which doc/architecture.md shows what a law has to say.
namespace rigid_body_sim::test {

/// A spring of rest length 0 that breaks at a given tension and then is gone.
class BreakingSpring final : public ForceLaw {
 public:
  BreakingSpring(const Spring::End& from, const Spring::End& to, double stiffness, double limit)
      : BreakingSpring(std::make_shared<Spring>(from, to, Spring::Constants{stiffness, 0, 0}),
                       stiffness, limit) {}

  const char* name() const override { return "breaking spring"; }
  std::vector<std::size_t> members() const override { return spring_->members(); }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override {
    return std::shared_ptr<ForceLaw>(
        new BreakingSpring(spring_->reindexed(index), stiffness_, limit_));
  }
  unsigned needs() const override { return spring_->needs(); }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override {
    spring_->addWrenches(at, wrenches);
  }
  double potentialEnergy(const Bodies& at) const override { return spring_->potentialEnergy(at); }
  double externalPower(const Bodies& at) const override { return spring_->externalPower(at); }
  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override {
    spring_->addStiffness(bodies, stiffness);
  }

  // its one state: 1 while it holds, then 0
  std::size_t stateCount() const override { return 1; }
  void setStart(double* own) const override { own[0] = 1; }
  bool acts(const double* own) const override { return own[0] == 1; }

  // its one event: the tension exceeds the limit
  std::size_t guardCount() const override { return 1; }
  void setGuards(const Bodies& at, double* guards) const override {
    // ½ k x² is ½ tension²/k
    const double tension = std::sqrt(2 * stiffness_ * spring_->potentialEnergy(at));
    guards[0] = acts(at.own) ? limit_ - tension : 1;
  }
  void switchMode(std::size_t, const Bodies&, double* own) const override { own[0] = 0; }

  /// Once it is broken, for ever.
  double quietUntil(double, const Bodies&) const override {
    return std::numeric_limits<double>::infinity();
  }

 private:
  BreakingSpring(std::shared_ptr<const ForceLaw> spring, double stiffness, double limit)
      : spring_(std::move(spring)), stiffness_(stiffness), limit_(limit) {}

  std::shared_ptr<const ForceLaw> spring_;
  double stiffness_;  // [N/m]
  double limit_;      // [N]
};

/// Pulls as a spring does while it is longer than its length, and not at all while it is shorter.
class String final : public ForceLaw {
 public:
  String(const Spring::End& from, const Spring::End& to, double stiffness, double length)
      : String(std::make_shared<Spring>(from, to, Spring::Constants{stiffness, 0, length}),
               std::make_shared<Spring>(from, to, Spring::Constants{1, 0, 0}), length) {}

  const char* name() const override { return "string"; }
  std::vector<std::size_t> members() const override { return spring_->members(); }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override {
    return std::shared_ptr<ForceLaw>(
        new String(spring_->reindexed(index), measure_->reindexed(index), length_));
  }
  unsigned needs() const override { return spring_->needs(); }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override {
    spring_->addWrenches(at, wrenches);
  }
  double potentialEnergy(const Bodies& at) const override { return spring_->potentialEnergy(at); }
  double externalPower(const Bodies&) const override { return 0; }
  void addStiffness(const std::vector<const Body*>& bodies,
                    std::vector<Stiffness>& stiffness) const override {
    spring_->addStiffness(bodies, stiffness);
  }

  // 1 while it is taut, else 0
  std::size_t stateCount() const override { return 1; }
  bool acts(const double* own) const override { return own[0] == 1; }
  std::size_t guardCount() const override { return 1; }
  void setGuards(const Bodies& at, double* guards) const override {
    const double excess = std::sqrt(2 * measure_->potentialEnergy(at)) - length_;
    guards[0] = acts(at.own) ? excess : -excess;
  }
  void switchMode(std::size_t, const Bodies&, double* own) const override { own[0] = 1 - own[0]; }

 private:
  String(std::shared_ptr<const ForceLaw> spring, std::shared_ptr<const ForceLaw> measure,
         double length)
      : spring_(std::move(spring)), measure_(std::move(measure)), length_(length) {}

  std::shared_ptr<const ForceLaw> spring_;
  std::shared_ptr<const ForceLaw> measure_;  // of rest length 0, stiffness 1: V = ½ l²
  double length_;                            // [m]
};

}  // namespace rigid_body_sim::test
