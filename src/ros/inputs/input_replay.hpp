#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// An input and the step after which the simulation takes it over; a state with which the run
/// begins is loaded before the first step.
struct TimedInput {
  std::uint64_t step = 0;
  SimulationInput input;
};

/// The inputs of the last run among messages of ~inputs, in any order. Throws
/// std::invalid_argument, one line, when one of the run is missing, when the step of one is less
/// than that of the one before, and for an input that is not of a run of this world.
std::vector<TimedInput> lastRun(std::vector<Input> messages, const World& world,
                                const std::string& world_frame);

/// Inputs of one run, applied to another after the same steps.
class InputReplay {
 public:
  explicit InputReplay(std::vector<TimedInput> inputs) : inputs_(std::move(inputs)) {}

  /// Applies what was taken over after the step that the simulation has come to. Returns whether
  /// that has moved bodies. Throws std::invalid_argument for an input that the simulation refuses.
  bool applyDue(Simulation& simulation);

  std::size_t size() const { return inputs_.size(); }

  /// Inputs that have not been applied yet.
  std::size_t remaining() const { return inputs_.size() - next_; }
  bool isDone() const { return remaining() == 0; }

  /// The step after which the next input is applied; beyond all steps where none is left.
  std::int64_t nextStep() const {
    return isDone() ? std::numeric_limits<std::int64_t>::max()
                    : static_cast<std::int64_t>(inputs_[next_].step);
  }

  /// The state with which the run begins; null where that is the start.
  const State* loaded() const {
    const auto* load = inputs_.empty() ? nullptr : std::get_if<LoadInput>(&inputs_[0].input);
    return load ? &load->state : nullptr;
  }

  /// The step of the last input; 0 without inputs. A run that ends before it leaves inputs out.
  std::uint64_t lastStep() const { return inputs_.empty() ? 0 : inputs_.back().step; }

 private:
  std::vector<TimedInput> inputs_;
  std::size_t next_ = 0;
};

}  // namespace rigid_body_sim
