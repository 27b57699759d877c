#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// The inputs of a recorded run, applied to another at the same steps.
class InputReplay {
 public:
  /// Keeps the inputs of the last run among those given, by number. Throws std::invalid_argument,
  /// one line, when one of them is missing.
  InputReplay(std::vector<Input> inputs, const std::string& world_frame);

  /// Applies what was taken over at the step that the simulation has come to. Returns whether that
  /// has moved bodies. Throws std::invalid_argument for an input that is not of this scene.
  bool applyDue(Simulation& simulation);

  std::size_t size() const { return inputs_.size(); }

  /// Whether every input has been applied.
  bool isDone() const { return next_ == inputs_.size(); }

 private:
  std::vector<Input> inputs_;
  std::string world_frame_;
  std::size_t next_ = 0;
};

}  // namespace rigid_body_sim
