#include <algorithm>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/coupling.hpp"

/// Which bodies a simulation advances together, and how.
namespace rigid_body_sim {

void Simulation::formGroupsAnew() {
  state();
  for (const Group& group : groups_)
    if (group.choice().controlled) markDisturbed(group);
  groups_.clear();
  formGroups();
}

/// Groups that are what they were go on as they are.
void Simulation::formGroups() {
  state();  // for groups to start from
  std::map<std::vector<std::size_t>, Group> former;
  for (Group& group : groups_) {
    if (group.choice().controlled) markDisturbed(group);
    former.emplace(group.members(), std::move(group));
  }
  groups_.clear();

  const std::vector<CoupledBodies> all = coupledBodies(*world_, schedules_);
  const auto trials = std::count_if(all.begin(), all.end(), [this](const CoupledBodies& bodies) {
    return bodies.members.size() > 1 || needsOf(*world_, bodies, schedules_) != 0;
  });
  const double share = std::min(1.0, kFullTrials / std::max(1.0, static_cast<double>(trials)));
  group_of_.assign(world_->bodies.size(), 0);
  for (const CoupledBodies& bodies : all) {
    for (std::size_t body : bodies.members) group_of_[body] = groups_.size();
    const unsigned needs = needsOf(*world_, bodies, schedules_);
    const auto same = former.find(bodies.members);
    if (same != former.end() && same->second.needs() == needs) {
      groups_.push_back(std::move(same->second));
      former.erase(same);
      continue;
    }
    MethodChoice choice = chosen(bodies, needs, share * kMostTrialSteps);
    choice.most_turn_share = most_turn_share_;
    groups_.emplace_back(*world_, bodies, needs, choice);
    groups_.back().restart(state_.t, schedules_);
  }
  for (const auto& [members, group] : former) addToFormer(group);
  foreseen_until_.clear();
  for (const Group& group : groups_) foreseen_until_.push_back(group.foreseenUntil(schedules_));
}

/// What a run counts outlives the groups in which it was counted.
void Simulation::addToFormer(const Group& group) {
  most_parts_ = std::max(most_parts_, group.mostParts());
  evaluations_ += group.evaluations();
}

/// The row named by the scene; with auto, none where the motion can be solved, else the cheapest
/// for the motion that the scene foretells, or what follows any other.
MethodChoice Simulation::chosen(const CoupledBodies& bodies, unsigned needs,
                                double most_trial_steps) {
  if (method_) {
    requireTaken(*method_, needs, world_->bodies[bodies.members.front()].name);
    return {method_};
  }
  if (bodies.members.size() == 1 && needs == 0) return {};
  if (std::any_of(bodies.members.begin(), bodies.members.end(),
                  [this](std::size_t body) { return disturbed_[body]; }))
    return controlledChoice();
  const auto known = choices_.find(bodies.members);
  if (known != choices_.end()) return known->second;
  return choices_[bodies.members] =
             chooseMethod(*world_, bodies, state_, schedules_, most_trial_steps);
}

/// Begins anew from the present, what acts on a body or its state being another from now on.
void Simulation::restartGroup(std::size_t body) {
  const std::size_t group = group_of_[body];
  catchUp(group);
  groups_[group].restart(state_.t, schedules_);
  foreseen_until_[group] = kNotForeseen;
}

/// Bodies that act on one another no longer move as the scene foretold.
void Simulation::disturb(std::size_t body) {
  Group& group = groups_[group_of_[body]];
  markDisturbed(group);
  group.distrustTrial();
}

void Simulation::markDisturbed(const Group& group) {
  for (std::size_t member : group.members()) disturbed_[member] = true;
}

}  // namespace rigid_body_sim
