#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "dynamics/packs/packs.hpp"
#include "dynamics/run/groups.hpp"

namespace rigid_body_sim {

/// Where a run is: what acts on the bodies now, and the groups in which they are advanced.
struct RunState {
  RunState(std::shared_ptr<const World> of, std::shared_ptr<const State> from)
      : world(std::move(of)), start(std::move(from)), changes(start->changes), laws(*world) {}

  /// The state of a body at a time [s] between the present of its group and the next step.
  BodyState at(std::size_t body, double t) const;

  /// The state of a body that moves, now.
  BodyState present(std::size_t body) const {
    return packs.holds(body) ? packs.state(body) : groups.at(body, time);
  }

  /// The group of index g, or a copy that goes on from where packs have led it.
  Group groupNow(std::size_t g) const;

  /// How group g is advanced.
  MotionPlan planOf(std::size_t g) const;

  /// Begins with nothing in packs.
  void beginPacks();

  /// Bodies by themselves may be fit for packs, as groups have formed anew.
  void offerAll();

  /// Moves bodies that are fit for it from their groups to packs, unless they have an event up to
  /// t_end [s].
  void pack(double t_end);

  /// Moves bodies back to their groups, which go on from the present.
  void unpack(std::size_t body);
  void unpackAll();
  void unpackEvents(double t_end);

  /// Takes steps with the packs, the last of which has led to the present. read: see Packs.
  void stepPacks(std::int64_t count, std::vector<BodyState>* read = nullptr);

  /// Whether a law acts, as its own states tell.
  bool acts(std::size_t law) const {
    return world->laws[law]->acts(law_states.data() + laws.firstState(law));
  }

  /// What has been counted of all bodies since the start, in groups and in packs.
  Groups::Counts counts() const {
    return {groups.maxSubsteps(), magnification(), evaluations(), groups.work()};
  }
  double magnification() const { return std::max(groups.magnification(), packs.magnification()); }
  std::int64_t evaluations() const { return groups.evaluations() + packs.evaluations(steps); }

  /// State::laws now.
  std::vector<double> lawStates() const;

  /// Advances a group, of these or a copy, to states that are finite. The meter is null where
  /// nobody asks. Throws SimulationDiverged.
  void advance(Group& group, double t_end, std::vector<WrenchSchedule>& group_schedules,
               ExchangeMeter* meter) const;

  std::shared_ptr<const World> world;  ///< with the changes
  std::shared_ptr<const State> start;  ///< of the run; fixed bodies stay there
  std::vector<BodyChange> changes;     ///< of the world, as State has them
  std::size_t world_changes = 0;       ///< how often it has become another
  LawTable laws;
  std::int64_t steps = 0;
  double time = 0;                        ///< [s] steps × time_step
  double horizon_begins = 0;              ///< see Simulation
  std::vector<double> law_states;         ///< State::laws; of laws that act, as old as their group
  std::vector<WrenchSchedule> schedules;  ///< one per body
  Groups groups;
  Packs packs;  ///< bodies that are advanced there and not by their groups
};

}  // namespace rigid_body_sim
