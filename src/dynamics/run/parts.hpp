#pragma once

#include <optional>
#include <utility>

#include "dynamics/run/balance.hpp"
#include "dynamics/run/error_tracker.hpp"
#include "dynamics/run/run.hpp"

namespace rigid_body_sim {

/// A run and what follows it where it is asked for.
struct Simulation::Parts {
  explicit Parts(Run started) : run(std::move(started)), first_world(run.now().world) { count(); }

  /// To actuators of all bodies.
  std::size_t commandsToCome() const {
    std::size_t count = 0;
    for (const WrenchSchedule& schedule : run.now().schedules)
      if (schedule.actuators()) count += schedule.actuators()->commandsToCome();
    return count;
  }

  /// What acts and is to come is another from now on.
  void count() {
    wrenches_at_most = 0;
    for (const WrenchSchedule& schedule : run.now().schedules) wrenches_at_most += schedule.size();
    commands_at_most = commandsToCome();
  }

  /// So is everything.
  void begin() {
    count();
    if (error) error.emplace(run);
    restartTracking();
  }

  /// The state is another from now on.
  void restartTracking() {
    if (balance) balance.emplace(*run.now().world, run.state());
    if (error) error->restart();
  }

  Run run;
  std::shared_ptr<const World> first_world;  ///< stays: others may have kept references to it
  std::optional<Balance> balance;
  std::optional<ErrorTracker> error;
  std::size_t wrenches_at_most = 0;  ///< not less than wrenchCount()
  std::size_t commands_at_most = 0;  ///< not less than commandsToCome()
};

}  // namespace rigid_body_sim
