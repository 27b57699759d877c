#include "ros/outputs/shown_bodies.hpp"

#include <algorithm>
#include <iterator>

namespace rigid_body_sim {
namespace {

/// Those of one ascending list that are not in another one.
std::vector<std::size_t> without(const std::vector<std::size_t>& all,
                                 const std::vector<std::size_t>& others) {
  std::vector<std::size_t> rest;
  std::set_difference(all.begin(), all.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
}

}  // namespace

void ShownBodies::add(std::size_t body) {
  all_.insert(std::lower_bound(all_.begin(), all_.end(), body), body);
}

void ShownBodies::remove(std::size_t body) {
  all_.erase(std::remove(all_.begin(), all_.end(), body), all_.end());
}

void ShownBodies::list(const World& world) {
  present_.clear();
  moving_.clear();
  for (const std::size_t body : all_) {
    if (!world.bodies[body].absent) present_.push_back(body);
    if (moves(world.bodies[body])) moving_.push_back(body);
  }
}

ShownBodies::Changes ShownBodies::follow(const Simulation& simulation) {
  if (simulation.worldChanges() == followed_changes_) return {};
  followed_changes_ = simulation.worldChanges();
  const std::vector<std::size_t> before = present_;
  list(simulation.world());
  return {without(present_, before), without(before, present_)};
}

}  // namespace rigid_body_sim
