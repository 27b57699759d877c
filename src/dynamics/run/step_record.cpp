#include "dynamics/run/step_record.hpp"

#include <utility>

namespace rigid_body_sim {

void StepRecord::clear() {
  advanced_.clear();
  scheduled_.clear();
  regrouped_.clear();
}

void StepRecord::beginGroup(std::size_t group, double t_end, Groups& groups,
                            std::vector<WrenchSchedule>& schedules) {
  groups.forgetKnown(group);
  advanced_.push_back(group);
  for (std::size_t body : groups[group].members())
    if (schedules[body].nextEvent() <= t_end && !schedules[body].isInStep()) {
      schedules[body].beginStep();
      scheduled_.push_back(body);
    }
}

void StepRecord::beginRegrouping(const Groups& groups, std::vector<double> law_states) {
  law_states_ = std::move(law_states);
  counts_ = groups.counts();
}

void StepRecord::keepGroup(std::size_t group, double time, const Groups& groups) {
  advanced_.pop_back();  // it is another by the end of the step
  const Group& found = groups[group];
  const std::size_t first = found.members().front();
  const bool is_found =
      found.time() <= time &&
      std::none_of(regrouped_.begin(), regrouped_.end(), [first](const Group& kept) {
        return std::binary_search(kept.members().begin(), kept.members().end(), first);
      });
  if (is_found) regrouped_.push_back(found);
}

std::vector<std::size_t> StepRecord::accept(double t_end, Groups& groups,
                                            std::vector<WrenchSchedule>& schedules) {
  for (std::size_t body : scheduled_) schedules[body].accept();
  std::vector<std::size_t> switched;
  for (std::size_t g : advanced_) {
    groups[g].accept(t_end);
    groups.findKnown(g, schedules);
    if (groups[g].switchedModes()) {
      const auto& members = groups[g].members();
      switched.insert(switched.end(), members.begin(), members.end());
    }
  }
  clear();
  return switched;
}

void StepRecord::takeBack(const World& world, Groups& groups,
                          std::vector<WrenchSchedule>& schedules, std::vector<double>& law_states) {
  for (std::size_t body : scheduled_) schedules[body].takeBack();
  if (regrouped_.empty()) {
    for (std::size_t g : advanced_) groups[g].rollBack(schedules);
  } else {
    takeBackGroups(world, groups, schedules);
    law_states = law_states_;
  }
  for (std::size_t g = 0; g < groups.size(); ++g) groups.findKnownOrRest(g, schedules);
  clear();
}

/// Where groups were linked or parted in the step.
void StepRecord::takeBackGroups(const World& world, Groups& groups,
                                const std::vector<WrenchSchedule>& schedules) {
  std::vector<std::size_t> bodies;
  for (const Group& found : regrouped_)
    bodies.insert(bodies.end(), found.members().begin(), found.members().end());
  groups.remove(groups.indicesOf(world, bodies));
  groups.setCounts(counts_);
  for (Group& group : groups.all()) group.rollBack(schedules);
  for (Group& found : regrouped_) groups.add(std::move(found), schedules);
}

}  // namespace rigid_body_sim
