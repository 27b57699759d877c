#include "dynamics/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

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

void Run::step() { stepMetered(); }
void Run::step(ExchangeMeter& meter) { stepMetered(meter); }

/// One step; of groups whose motion is known beyond it only if they are metered.
template <class... Meter>
void Run::stepMetered(Meter&... meter) {
  const double t_end = static_cast<double>(steps_ + 1) * world_->solver.time_step;
  step_.start();
  try {
    if (next_link_ <= t_end || watches_.quietUntil() <= t_end) advanceLinking(t_end, meter...);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (t_end < groups_.knownUntil(g) && sizeof...(Meter) == 0) continue;
      step_.beginGroup(g, t_end, groups_, schedules_);
      advance(groups_[g], t_end, schedules_, meter...);
    }
  } catch (const SimulationDiverged&) {
    takeBack();
    throw;
  }
  accept(t_end);
}

/// Advances a group to states that are finite.
template <class... Meter>
void Run::advance(Group& group, double t_end, std::vector<WrenchSchedule>& schedules,
                  Meter&... meter) const {
  const double t = std::max(time_, group.time());
  try {
    group.advance(t, t_end, schedules, meter...);
  } catch (const StepTooLong& reason) {
    throw SimulationDiverged(t, world_->bodies[group.members()[0]].name, reason.what());
  }
  requireFinite(*world_, group, t);
}

void Run::takeBack() {
  const bool regrouped = step_.hasRegrouped();
  step_.takeBack(*world_, groups_, schedules_, law_states_);
  if (regrouped) findNextLink();
  watches_.wakeUp();
}

void Run::accept(double t_end) {
  if (step_.hasRegrouped()) findNextLink();
  const std::vector<std::size_t> switched = step_.accept(t_end, groups_, schedules_);
  time_ = t_end;
  ++steps_;
  if (!switched.empty()) regroup(switched, t_end);
}

std::vector<double> Run::lawStates() const {
  std::vector<double> states = law_states_;
  if (!states.empty())
    for (const Group& group : groups_.all()) group.putLawStates(laws_, states);
  return states;
}

State Run::state() const {
  State state;
  state.t = time_;
  state.laws = lawStates();
  if (!start_->actuators.empty()) state.actuators = actuatorStates(schedules_);
  state.bodies.reserve(world_->bodies.size());
  for (std::size_t i = 0; i < world_->bodies.size(); ++i) state.bodies.push_back(body(i));
  state.anchors.resize(world_->bodies.size());
  for (const Group& group : groups_.all()) {
    for (std::size_t k = 0; k < group.members().size(); ++k)
      state.anchors[group.members()[k]] = group.anchorOf(k);
    state.plans.push_back(toPlan(group));
  }
  return state;
}

State Run::sample(double t) const {
  if (linksUntil(t)) return sampleLinking(t);
  State sampled;
  sampled.t = t;
  sampled.laws = lawStates();
  sampled.bodies = start_->bodies;
  std::vector<WrenchSchedule> schedules;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const std::vector<std::size_t>& members = groups_[g].members();
    if (t < groups_.knownUntil(g) || t <= time_) {
      for (std::size_t k = 0; k < members.size(); ++k)
        sampled.bodies[members[k]] = groups_[g].at(std::max(t, time_), k);
      continue;
    }
    if (schedules.empty()) schedules = schedules_;
    Group group = groups_[g];
    advance(group, t, schedules);
    group.accept(t);
    for (std::size_t k = 0; k < members.size(); ++k)
      sampled.bodies[members[k]] = group.present().bodies[k];
    if (!sampled.laws.empty()) group.putLawStates(laws_, sampled.laws);
  }
  if (!start_->actuators.empty())
    sampled.actuators = actuatorStates(schedules.empty() ? schedules_ : schedules);
  return sampled;
}

/// A copy that goes on to a time between now and the next step, through whatever links or parts
/// bodies meanwhile.
Run Run::goneOnTo(double t) const {
  Run copy = *this;
  if (!(t > time_)) return copy;
  copy.advanceLinking(t);
  for (Group& group : copy.groups_.all()) {
    copy.advance(group, t, copy.schedules_);
    group.accept(t);
  }
  copy.time_ = t;
  return copy;
}

/// The same where bodies may be linked or parted meanwhile.
State Run::sampleLinking(double t) const {
  State sampled = goneOnTo(t).state();
  sampled.anchors.clear();
  sampled.plans.clear();
  return sampled;
}

template void Run::advance(Group&, double, std::vector<WrenchSchedule>&) const;
template void Run::advance(Group&, double, std::vector<WrenchSchedule>&, ExchangeMeter&) const;

}  // namespace rigid_body_sim
