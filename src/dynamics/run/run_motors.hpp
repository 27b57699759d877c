#pragma once

#include <memory>
#include <vector>

#include "dynamics/actuators/actuator_table.hpp"
#include "dynamics/run/run_state.hpp"

namespace rigid_body_sim {

/// The motors of a run: how they start, and how they follow a body whose state is set. What they
/// are commanded and do is part of its schedule.
class RunMotors {
 public:
  /// start: of the run.
  RunMotors(const World& world, const State& start);

  /// The same start, with the actuators where it has none.
  static std::shared_ptr<const State> complete(const World& world,
                                               std::shared_ptr<const State> start);

  /// Puts them into the schedules of a run that begins at a state. scheduled: with those commands
  /// of the scene that the state has not taken yet.
  void place(RunState& run, const State& start, bool scheduled) const;

  /// State::actuators.
  std::vector<std::vector<ActuatorState>> states(
      const std::vector<WrenchSchedule>& schedules) const;

  /// A state to which a body is set: the speeds of wheels and rotors relative to it stay, and L_W
  /// includes their momentum. Throws nothing.
  BodyState follow(RunState& run, std::size_t body, const BodyState& state) const;

 private:
  std::vector<std::shared_ptr<const ActuatorTable>> tables_;  // by body; none in a world without
  bool commanded_;  // whether the run started from a state in which commands were taken already
};

}  // namespace rigid_body_sim
