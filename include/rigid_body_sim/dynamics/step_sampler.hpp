#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// States within the step that comes next, one after the other, each from the last one on: where
/// bodies touch, Simulation::sample integrates from the start of the step for every one of them.
/// They err as little, and have other bits, which depend on what was asked before.
class StepSampler {
 public:
  /// From the present step of a simulation, of which it is independent from then on.
  explicit StepSampler(const Simulation& simulation);
  ~StepSampler();
  StepSampler(StepSampler&& other) noexcept;
  StepSampler& operator=(StepSampler&& other) noexcept;

  /// To a time t [s], from which the next state goes on. Throws as at().
  void goTo(double t);

  /// The state at a time t [s] from the last one on and up to the end of the step. Throws
  /// std::invalid_argument for another, and SimulationDiverged.
  State at(double t);

  /// The same of Simulation::motions.
  std::vector<BodyMotion> motions(const std::vector<std::size_t>& bodies, double t);

  /// Evaluations of all forces so far.
  std::int64_t evaluations() const;

 private:
  class Ahead;
  std::unique_ptr<Ahead> ahead_;
};

/// States within steps, whichever step a simulation is at. In contact those of one step go on from
/// one another from the second instant on, so that many cost little more than the step; others are
/// those of Simulation::sample and motions.
class StatesWithin {
 public:
  StatesWithin() = default;

  /// Of the instants k / rate: bits do not depend on which of them are asked for, as those that are
  /// not are gone through, too. Throws std::invalid_argument unless rate [1/s] is > 0 and finite.
  explicit StatesWithin(double rate);

  /// At a time t [s] within the step that comes next.
  State at(const Simulation& simulation, double t);
  std::vector<BodyMotion> motions(const Simulation& simulation,
                                  const std::vector<std::size_t>& bodies, double t);

  /// To be called where an input, or another simulation, comes in between two of one step.
  void restart();

 private:
  StepSampler* samplerFor(const Simulation& simulation, double t);
  void goThrough(const Simulation& simulation, double t);

  double rate_ = 0;  // 0: none
  std::int64_t step_ = -1;
  double last_ = 0;  // [s]
  std::optional<StepSampler> sampler_;
};

}  // namespace rigid_body_sim
