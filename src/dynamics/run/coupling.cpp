#include "dynamics/run/coupling.hpp"

#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {
namespace {

/// Representative of a body in a forest of parents (union–find with path halving).
std::size_t root(std::vector<std::size_t>& parent, std::size_t body) {
  while (parent[body] != body) body = parent[body] = parent[parent[body]];
  return body;
}

}  // namespace

std::vector<std::vector<std::size_t>> linkedBodies(
    const std::vector<Body>& bodies, const std::vector<std::vector<std::size_t>>& bonds) {
  std::vector<std::size_t> parent(bodies.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (const std::vector<std::size_t>& bond : bonds) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t first = kNone;
    for (std::size_t body : bond) {
      if (bodies[body].fixed) continue;
      if (first == kNone) first = body;
      parent[root(parent, body)] = root(parent, first);
    }
  }
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> group_of(bodies.size(), bodies.size());
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (bodies[body].fixed) continue;
    std::size_t& group = group_of[root(parent, body)];
    if (group == bodies.size()) {
      group = groups.size();
      groups.emplace_back();
    }
    groups[group].push_back(body);
  }
  return groups;
}

std::vector<CoupledBodies> coupledBodies(const World& world,
                                         const std::vector<WrenchSchedule>& schedules) {
  std::vector<std::vector<std::size_t>> bonds;
  for (const auto& law : world.laws) {
    bonds.push_back(law->members());
    assert(!bonds.back().empty());
    for ([[maybe_unused]] std::size_t body : bonds.back()) assert(!world.bodies[body].fixed);
  }
  for (const WrenchSchedule& schedule : schedules) bonds.push_back(schedule.bodies());
  std::vector<CoupledBodies> groups;
  std::vector<std::size_t> group_of(world.bodies.size());
  for (std::vector<std::size_t>& members : linkedBodies(world.bodies, bonds)) {
    for (std::size_t body : members) group_of[body] = groups.size();
    groups.push_back({std::move(members), {}});
  }
  for (const auto& law : world.laws) groups[group_of[law->members().front()]].laws.push_back(law);
  return groups;
}

unsigned needsOf(const World& world, const CoupledBodies& group,
                 const std::vector<WrenchSchedule>& schedules) {
  unsigned needs = group.laws.empty() ? 0u : kCoupling;
  for (const auto& law : group.laws)
    if (law->isDamped()) needs |= kDamping;
  for (std::size_t body : group.members) {
    if (world.bodies[body].drag.any()) needs |= kDrag;
    if (!schedules[body].allHeld()) needs |= kCoupling;
  }
  return needs;
}

void requireTaken(const World& world) {
  std::vector<WrenchSchedule> schedules(world.bodies.size());
  for (const PointWrench& wrench : world.wrenches) schedules[wrench.body].put("", wrench, 0);
  const Method& method = methodNamed(world.solver.integrator);
  for (const CoupledBodies& group : coupledBodies(world, schedules))
    requireTaken(method, needsOf(world, group, schedules),
                 world.bodies[group.members.front()].name);
}

}  // namespace rigid_body_sim
