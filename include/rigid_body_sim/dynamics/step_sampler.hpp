#pragma once

#include <cstdint>
#include <memory>

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

  /// The state at a time t [s] from the last one on and up to the end of the step. Throws
  /// std::invalid_argument for another, and SimulationDiverged.
  State at(double t);

  /// Evaluations of all forces so far.
  std::int64_t evaluations() const;

 private:
  class Ahead;
  std::unique_ptr<Ahead> ahead_;
};

}  // namespace rigid_body_sim
