#include "dynamics/run/groups.hpp"

#include <set>
#include <utility>

namespace rigid_body_sim {

void Groups::clear(std::size_t bodies) {
  groups_.clear();
  known_until_.clear();
  group_of_.assign(bodies, 0);
  member_of_.assign(bodies, kNone);
  feeds_least_axis_ = false;
  removed_ = {};
}

void Groups::add(Group group, const std::vector<WrenchSchedule>& schedules) {
  for (std::size_t k = 0; k < group.members().size(); ++k) {
    group_of_[group.members()[k]] = groups_.size();
    member_of_[group.members()[k]] = k;
  }
  known_until_.push_back(knownOrRest(group, schedules));
  const Method* method = group.choice().method;
  feeds_least_axis_ |= method && method->claimsTo(kFeedsLeastAxis);
  groups_.push_back(std::move(group));
}

std::vector<std::size_t> Groups::indicesOf(const World& world,
                                           const std::vector<std::size_t>& bodies) const {
  std::set<std::size_t> groups;
  for (std::size_t body : bodies)
    if (moves(world.bodies[body])) groups.insert(group_of_[body]);
  return {groups.begin(), groups.end()};
}

void Groups::remove(const std::vector<std::size_t>& indices) {
  for (auto g = indices.rbegin(); g != indices.rend(); ++g) {
    removed_.max_substeps = std::max(removed_.max_substeps, groups_[*g].maxSubsteps());
    removed_.magnification = std::max(removed_.magnification, groups_[*g].magnification());
    removed_.evaluations += groups_[*g].evaluations();
    removed_.work += workOf(groups_[*g]);
    erase(*g);
  }
}

/// The last takes its place.
void Groups::erase(std::size_t g) {
  if (g + 1 < groups_.size()) {
    groups_[g] = std::move(groups_.back());
    known_until_[g] = known_until_.back();
    for (std::size_t body : groups_[g].members()) group_of_[body] = g;
  }
  groups_.pop_back();
  known_until_.pop_back();
}

int Groups::maxSubsteps() const {
  int most = removed_.max_substeps;
  for (const Group& group : groups_) most = std::max(most, group.maxSubsteps());
  return most;
}

double Groups::magnification() const {
  double most = removed_.magnification;
  if (!feeds_least_axis_) return most;
  for (const Group& group : groups_) most = std::max(most, group.magnification());
  return most;
}

std::int64_t Groups::evaluations() const {
  std::int64_t sum = removed_.evaluations;
  for (const Group& group : groups_) sum += group.evaluations();
  return sum;
}

double Groups::work() const {
  double sum = removed_.work;
  for (const Group& group : groups_) sum += workOf(group);
  return sum;
}

}  // namespace rigid_body_sim
