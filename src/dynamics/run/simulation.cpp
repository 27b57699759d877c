#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {
namespace {

std::string divergedMessage(double time, const std::string& body, const std::string& quantity) {
  std::ostringstream message;
  message.precision(17);
  message << "t = " << time << " s: body '" << body << "': " << quantity;
  return message.str();
}

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

}  // namespace

SimulationDiverged::SimulationDiverged(double t, const std::string& b, const std::string& q)
    : std::runtime_error(divergedMessage(t, b, q)), time(t), body(b), quantity(q) {}

Simulation::Simulation(World world, State initial)
    : world_(std::make_shared<const World>(std::move(world))),
      initial_(std::make_shared<const State>(std::move(initial))),
      method_(world_->solver.integrator == "auto" ? nullptr
                                                  : &methodNamed(world_->solver.integrator)) {
  reset(true);
}

void Simulation::reset(bool restart_time) {
  if (restart_time) steps_ = 0;
  state_ = *initial_;
  state_.t = static_cast<double>(steps_) * world_->solver.time_step;
  schedules_.assign(world_->bodies.size(), WrenchSchedule());
  if (restart_time)
    for (const PointWrench& wrench : world_->wrenches)
      schedules_[wrench.body].put("", onSteps(wrench), state_.t);
  at_most_ = wrenchCount();
  groups_.clear();
  most_parts_ = 1;
  evaluations_ = 0;
  disturbed_.assign(world_->bodies.size(), false);
  // what was tried with the scene's wrenches, which come no more
  if (!restart_time && !world_->wrenches.empty()) choices_.clear();
  formGroups();
  coarse_.reset();
  error_ = ErrorEstimate();
  startBalance();
}

const State& Simulation::state() const {
  if (lags_)
    for (std::size_t g = 0; g < groups_.size(); ++g) catchUp(g);
  lags_ = false;
  return state_;
}

/// Evaluates the present of a group whose motion is foreseen.
void Simulation::catchUp(std::size_t group) const {
  if (lags_ && state_.t < foreseen_until_[group])
    groups_[group].putForeseen(state_.t, state_.bodies);
}

void Simulation::step() {
  if (tracked_) return trackedStep();
  stepBy(false);
}

void Simulation::trackedStep() {
  if (balance_) {
    stepBy(true, balance_->beginStep());
    balance_->endStep();
  } else {
    stepBy(true);
  }
  if (tracks_error_ && steps_ % 2 == 0) followCoarse();
}

/// One step; of groups that are foreseen beyond it only if they are to take it, too.
template <class... Meter>
void Simulation::stepBy(bool foreseen_too, Meter&... meter) {
  const double t_end = static_cast<double>(steps_ + 1) * world_->solver.time_step;
  advanced_.clear();
  scheduled_.clear();
  try {
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (t_end < foreseen_until_[g] && !foreseen_too) continue;
      begin(g, t_end);
      advance(groups_[g], t_end, schedules_, meter...);
    }
  } catch (const SimulationDiverged&) {
    takeBack();
    throw;
  }
  accept(t_end);
}

/// Advances a group from the present, on its own account, to a state that is finite.
template <class... Meter>
void Simulation::advance(Group& group, double t_end, std::vector<WrenchSchedule>& schedules,
                         Meter&... meter) const {
  const auto nameOf = [&](std::size_t k) { return world_->bodies[group.members()[k]].name; };
  try {
    group.advance(state_.t, t_end, schedules, state_.bodies, meter...);
  } catch (const StepTooLong& reason) {
    throw SimulationDiverged(state_.t, nameOf(0), reason.what());
  }
  for (std::size_t k = 0; k < group.states().size(); ++k) {
    if (std::isfinite(sumOfAll(group.states()[k]))) continue;
    if (const char* quantity = nonFiniteQuantity(group.states()[k]))
      throw SimulationDiverged(state_.t, nameOf(k), quantity);
  }
}

/// Keeps what takeBack needs.
void Simulation::begin(std::size_t group, double t_end) {
  catchUp(group);
  foreseen_until_[group] = kNotForeseen;
  advanced_.push_back(group);
  for (std::size_t body : groups_[group].members())
    if (schedules_[body].nextEvent() <= t_end) {
      schedules_[body].beginStep();
      scheduled_.push_back(body);
    }
}

/// Makes a step that has failed one that was never begun.
void Simulation::takeBack() {
  for (std::size_t body : scheduled_) schedules_[body].takeBack();
  for (std::size_t g : advanced_) groups_[g].restart(state_.t, schedules_);
}

/// Makes the step's end the present.
void Simulation::accept(double t_end) {
  for (std::size_t body : scheduled_) schedules_[body].accept();
  for (std::size_t g : advanced_) {
    groups_[g].putStates(state_.bodies);
    foreseen_until_[g] = groups_[g].foreseenUntil(schedules_);
  }
  lags_ = advanced_.size() < groups_.size();
  state_.t = t_end;
  ++steps_;
}

State Simulation::sample(double t) const {
  State sampled{t, state().bodies};
  std::vector<WrenchSchedule> schedules = schedules_;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (t < foreseen_until_[g]) {
      groups_[g].putForeseen(t, sampled.bodies);
      continue;
    }
    Group group = groups_[g];
    advance(group, t, schedules);
    group.putStates(sampled.bodies);
  }
  return sampled;
}

void Simulation::apply(const SimulationInput& input) {
  if (const auto* wrench = std::get_if<WrenchInput>(&input)) {
    applyWrench(wrench->slot, wrench->wrench);
  } else if (const auto* clear = std::get_if<ClearInput>(&input)) {
    const bool all = clear->body == ClearInput::kEveryBody;
    if (all && clear->slot.empty()) return clearWrenches();
    if (all) return clearWrenches(clear->slot);
    if (clear->slot.empty()) return clearWrenches(clear->body);
    clearWrenches(clear->body, clear->slot);
  } else if (const auto* state = std::get_if<StateInput>(&input)) {
    setState(state->body, toBodyState(world_->bodies[state->body], state->motion));
  } else {
    reset(std::get<ResetInput>(input).restart_time);
  }
}

void Simulation::applyWrench(const std::string& slot, const PointWrench& wrench) {
  const Body& body = world_->bodies[wrench.body];
  assert(!body.fixed);
  if (at_most_ >= kMostWrenches) at_most_ = wrenchCount();
  if (at_most_ >= kMostWrenches && !replaces(slot, wrench))
    throw std::invalid_argument("at most " + std::to_string(kMostWrenches) +
                                " wrenches may act or be to come");
  if (method_ && !HeldWrench::holds(wrench)) requireTaken(*method_, kCoupling, body.name);
  const PointWrench on_steps = onSteps(wrench);
  put(slot, on_steps);
  if (!coarse_) return;
  ownCoarse().choices_ = choices_;
  coarse_->put(slot, on_steps);
}

bool Simulation::replaces(const std::string& slot, const PointWrench& wrench) const {
  return !slot.empty() && wrench.start <= state_.t && schedules_[wrench.body].holds(slot);
}

/// With a start or end that misses the end of a step by rounding moved there: 0.1 s + 0.2 s is 300
/// steps of 1 ms, and not a step that is split 6e-17 s after its start.
PointWrench Simulation::onSteps(PointWrench wrench) const {
  const double h = world_->solver.time_step;
  for (double* t : {&wrench.start, &wrench.end}) {
    const double step = std::round(*t / h) * h;
    if (std::abs(*t - step) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(step))
      *t = step;
  }
  return wrench;
}

void Simulation::put(const std::string& slot, const PointWrench& wrench) {
  schedules_[wrench.body].put(slot, wrench, state_.t);
  ++at_most_;
  disturb(wrench.body);
  restartGroup(wrench.body);
  if (!HeldWrench::holds(wrench)) formGroups();
}

void Simulation::clearWrenches() {
  clearBodies(0, schedules_.size(), [](WrenchSchedule& schedule) { return schedule.clear(); });
}

void Simulation::clearWrenches(const std::string& slot) {
  clearBodies(0, schedules_.size(), [&](WrenchSchedule& schedule) { return schedule.clear(slot); });
}

void Simulation::clearWrenches(std::size_t body) {
  clearBodies(body, body + 1, [](WrenchSchedule& schedule) { return schedule.clear(); });
}

void Simulation::clearWrenches(std::size_t body, const std::string& slot) {
  clearBodies(body, body + 1, [&](WrenchSchedule& schedule) { return schedule.clear(slot); });
}

/// clear(schedule) returns whether anything has gone.
template <class Clear>
void Simulation::clearBodies(std::size_t begin, std::size_t end, const Clear& clear) {
  bool uncoupled = false;
  for (std::size_t body = begin; body < end; ++body) {
    const bool all_held = schedules_[body].allHeld();
    if (!clear(schedules_[body])) continue;
    disturb(body);
    restartGroup(body);
    uncoupled |= !all_held;
    coarse_.reset();
  }
  if (uncoupled) formGroups();
}

int Simulation::mostParts() const {
  int most = most_parts_;
  for (const Group& group : groups_) most = std::max(most, group.mostParts());
  return most;
}

std::int64_t Simulation::evaluations() const {
  std::int64_t sum = evaluations_;
  for (const Group& group : groups_) sum += group.evaluations();
  return sum;
}

std::size_t Simulation::wrenchCount() const {
  std::size_t count = 0;
  for (const WrenchSchedule& schedule : schedules_) count += schedule.size();
  return count;
}

Wrench Simulation::appliedWrench(std::size_t body) const {
  Wrench wrench;
  for (const PointWrench& applied : schedules_[body].active())
    addPointWrench(applied, state().bodies, wrench);
  return wrench;
}

void Simulation::setState(std::size_t body, const BodyState& state) {
  assert(!world_->bodies[body].fixed);
  disturb(body);
  restartGroup(body);
  state_.bodies[body] = state;
  coarse_.reset();
  startBalance();
}

}  // namespace rigid_body_sim
