#pragma once

#include <optional>
#include <utility>

#include "dynamics/run/balance.hpp"
#include "dynamics/run/error_tracker.hpp"
#include "dynamics/run/run.hpp"

namespace rigid_body_sim {

/// A run and what follows it where it is asked for.
struct Simulation::Parts {
  explicit Parts(Run started) : run(std::move(started)) {
    for (const WrenchSchedule& schedule : run.schedules()) wrenches_at_most += schedule.size();
  }

  /// The state is another from now on.
  void restartTracking() {
    if (balance) balance.emplace(run.world(), run.state());
    if (error) error->restart();
  }

  Run run;
  std::optional<Balance> balance;
  std::optional<ErrorTracker> error;
  std::size_t wrenches_at_most = 0;  ///< not less than wrenchCount()
};

}  // namespace rigid_body_sim
