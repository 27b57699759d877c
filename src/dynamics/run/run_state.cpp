#include "dynamics/run/run_state.hpp"

#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {
namespace {

/// The first quantity of a state that is not finite; null when all are.
const char* nonFiniteQuantity(const BodyState& s) {
  if (!s.x_W.allFinite() || !s.x_low_W.allFinite()) return "position is no longer finite";
  if (!s.q_WP.coeffs().allFinite()) return "attitude is no longer finite";
  if (!s.p_W.allFinite()) return "momentum is no longer finite";
  if (!s.L_W.allFinite() || !s.L_P.allFinite()) return "angular momentum is no longer finite";
  return nullptr;
}

/// Finite only where all coefficients are: one test for the rule, nonFiniteQuantity for the rest.
double sumOfAll(const BodyState& s) {
  return (s.x_W + s.x_low_W + s.p_W + s.L_W + s.L_P).sum() + s.q_WP.coeffs().sum();
}

/// Throws for a group that has been advanced from t to what is not finite.
void requireFinite(const World& world, const Group& group, double t) {
  const SystemState& next = group.advanced();
  for (std::size_t k = 0; k < next.bodies.size(); ++k) {
    if (std::isfinite(sumOfAll(next.bodies[k]))) continue;
    if (const char* quantity = nonFiniteQuantity(next.bodies[k]))
      throw SimulationDiverged(t, world.bodies[group.members()[k]].name, quantity);
  }
  for (double own : next.laws)
    if (!std::isfinite(own))
      throw SimulationDiverged(t, world.bodies[group.members()[0]].name,
                               "state of a law on it is no longer finite");
}

}  // namespace

void RunState::advance(Group& group, double t_end, std::vector<WrenchSchedule>& group_schedules,
                       ExchangeMeter* meter) const {
  const double t = std::max(time, group.time());
  try {
    if (meter)
      group.advance(t, t_end, group_schedules, *meter);
    else
      group.advance(t, t_end, group_schedules);
  } catch (const StepTooLong& reason) {
    throw SimulationDiverged(t, world->bodies[group.members()[0]].name, reason.what());
  }
  requireFinite(*world, group, t);
}

BodyState RunState::at(std::size_t body, double t) const {
  if (!moves(world->bodies[body])) return start->bodies[body];
  const std::size_t g = groups.indexOf(body);
  if (packs.holds(body)) {
    if (t <= time) return packs.state(body);
  } else if (t < groups.knownUntil(g) || t <= std::max(time, groups[g].time())) {
    return groups.at(body, t);
  }
  Group group = groupNow(g);
  std::vector<WrenchSchedule> copy = schedules;
  advance(group, t, copy, nullptr);
  return group.advanced().bodies[groups.memberOf(body)];
}

std::vector<double> RunState::lawStates() const {
  std::vector<double> states = law_states;
  if (!states.empty())
    for (const Group& group : groups.all()) group.putLawStates(laws, states);
  return states;
}

}  // namespace rigid_body_sim
