#pragma once

#include <memory>
#include <vector>

#include "dynamics/run/groups.hpp"

namespace rigid_body_sim {

/// Where a run is: what acts on the bodies now, and the groups in which they are advanced.
struct RunState {
  RunState(std::shared_ptr<const World> of, std::shared_ptr<const State> from)
      : world(std::move(of)), start(std::move(from)), laws(*world) {}

  /// The state of a body at a time [s] between the present of its group and the next step.
  BodyState at(std::size_t body, double t) const;

  /// Whether a law acts, as its own states tell.
  bool acts(std::size_t law) const {
    return world->laws[law]->acts(law_states.data() + laws.firstState(law));
  }

  /// State::laws now.
  std::vector<double> lawStates() const;

  /// Advances a group, of these or a copy, to states that are finite. The meter is null where
  /// nobody asks. Throws SimulationDiverged.
  void advance(Group& group, double t_end, std::vector<WrenchSchedule>& group_schedules,
               ExchangeMeter* meter) const;

  std::shared_ptr<const World> world;
  std::shared_ptr<const State> start;  ///< of the run; fixed bodies stay there
  LawTable laws;
  std::int64_t steps = 0;
  double time = 0;                        ///< [s] steps × time_step
  std::vector<double> law_states;         ///< State::laws; of laws that act, as old as their group
  std::vector<WrenchSchedule> schedules;  ///< one per body
  Groups groups;
};

}  // namespace rigid_body_sim
