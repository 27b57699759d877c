#pragma once

#include <vector>

#include "dynamics/run/groups.hpp"

namespace rigid_body_sim {

/// What a step has begun, to be accepted or taken back as a whole; nothing between steps. Memory is
/// kept from step to step.
class StepRecord {
 public:
  /// Before a group is advanced to t_end [s] or on the way there.
  void beginGroup(std::size_t group, double t_end, Groups& groups,
                  std::vector<WrenchSchedule>& schedules);

  /// Before groups are formed anew within the step: what takeBack needs for that.
  void beginRegrouping(const Groups& groups, std::vector<double> law_states);

  /// Before a group, as the step at `time` [s] found it or formed since, is advanced to an instant
  /// at which it is formed anew.
  void keepGroup(std::size_t group, double time, const Groups& groups);

  /// Whether there is anything to accept: not where all motion is known beforehand.
  bool hasBegun() const { return !advanced_.empty() || !scheduled_.empty() || hasRegrouped(); }

  bool hasRegrouped() const { return !regrouped_.empty(); }

  /// Bodies with an event within the step.
  const std::vector<std::size_t>& scheduled() const { return scheduled_; }

  /// Makes the step's end the present. Returns the members of groups of which a law has switched.
  std::vector<std::size_t> accept(double t_end, Groups& groups,
                                  std::vector<WrenchSchedule>& schedules);

  /// Makes the step one that was never begun.
  void takeBack(const World& world, Groups& groups, std::vector<WrenchSchedule>& schedules,
                std::vector<double>& law_states);

 private:
  void takeBackGroups(const World& world, Groups& groups,
                      const std::vector<WrenchSchedule>& schedules);
  void clear();

  std::vector<std::size_t> advanced_;   // groups
  std::vector<std::size_t> scheduled_;  // bodies with an event within the step
  std::vector<Group> regrouped_;        // as the step found them
  std::vector<double> law_states_;      // likewise; only where groups are formed anew
  Groups::Counts counts_;               // likewise
};

}  // namespace rigid_body_sim
