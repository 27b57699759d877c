#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ros/bag/bag_inputs.hpp"
#include "ros/inputs/input_replay.hpp"
#include "tools/simulate/input_effects.hpp"

namespace rigid_body_sim {

/// The run of a node in a bag, to be repeated.
class RecordedRun {
 public:
  /// Throws std::runtime_error with one line, the path first, for a bag that cannot be used.
  RecordedRun(const std::string& path, const Scene& scene, const World& world);

  /// A line for the user about what the bag does not hold; may be empty.
  std::string notice() const;

  /// [s] Where the recorded run began: at zero, or at the time of a state that was loaded.
  double begin() const { return replay_.loaded() ? replay_.loaded()->t : 0; }

  /// [s] Where it ended, at a step; where the bag does not show it, a horizon after the start or
  /// where its inputs cease to act, whichever is later.
  double end(const Scene& scene) const;

  /// A line for the user where that is not known because the run is not the first in the bag; may
  /// be empty.
  std::string lengthNotice(const Scene& scene) const;

  const TimeOrigin& origin() const { return recorded_.origin; }
  InputReplay& replay() { return replay_; }
  std::int64_t nextStep() const { return replay_.nextStep(); }

  /// Of the inputs that have been applied so far.
  std::vector<InputEffects> effects(const World& world) const;

  /// A line about inputs that a run up to this time [s] has not applied; empty if there is none.
  std::string remainder(double end) const;

 private:
  bool showsItsEnd(double h) const;

  std::string path_;
  BagInputs recorded_;
  std::optional<double> end_;  // [s]
  InputReplay replay_;
};

}  // namespace rigid_body_sim
