#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <rigid_body_sim/dynamics/coupling.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {
namespace {

std::string divergedMessage(double time, const std::string& body, const std::string& quantity) {
  std::ostringstream message;
  message.precision(17);
  message << "t = " << time << " s: body '" << body << "': " << quantity;
  return message.str();
}

constexpr double kNotForeseen = -std::numeric_limits<double>::infinity();

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
      schedules_[wrench.body].put("", wrench, state_.t);
  groups_.clear();
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
  stepBy(false, [](Group& group, auto&... between) { group.advance(between...); });
}

void Simulation::trackedStep() {
  if (balance_) {
    ExchangeMeter& meter = balance_->beginStep();
    stepBy(true, [&](Group& group, auto&... between) { group.advance(between..., meter); });
    balance_->endStep();
  } else {
    stepBy(true, [](Group& group, auto&... between) { group.advance(between...); });
  }
  if (tracks_error_ && steps_ % 2 == 0) followCoarse();
}

/// One step, each group by advance(group, t, t_end, schedules, bodies), but those that are foreseen
/// beyond it only if they are to be, too.
template <class Advance>
void Simulation::stepBy(bool foreseen_too, const Advance& advance) {
  const double t_end = static_cast<double>(steps_ + 1) * world_->solver.time_step;
  advanced_.clear();
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (t_end < foreseen_until_[g] && !foreseen_too) continue;
    // from here on state_ holds its present, should the step fail
    catchUp(g);
    foreseen_until_[g] = kNotForeseen;
    advanced_.push_back(g);
    try {
      advance(groups_[g], state_.t, t_end, schedules_, state_.bodies);
    } catch (const StepTooLong& reason) {
      throw SimulationDiverged(state_.t, world_->bodies[groups_[g].members().front()].name,
                               reason.what());
    }
  }
  acceptStep(t_end);
}

void Simulation::requireFinite(const Group& group) const {
  for (std::size_t k = 0; k < group.members().size(); ++k) {
    if (std::isfinite(sumOfAll(group.states()[k]))) continue;
    if (const char* quantity = nonFiniteQuantity(group.states()[k]))
      throw SimulationDiverged(state_.t, world_->bodies[group.members()[k]].name, quantity);
  }
}

/// Makes the step's end the present, where it is finite.
void Simulation::acceptStep(double t_end) {
  for (std::size_t g : advanced_) requireFinite(groups_[g]);
  for (std::size_t g : advanced_) {
    groups_[g].putStates(state_.bodies);
    foreseen_until_[g] = groups_[g].foreseenUntil(schedules_);
  }
  lags_ |= advanced_.size() < groups_.size();
  state_.t = t_end;
  ++steps_;
}

State Simulation::sample(double t) const {
  std::vector<WrenchSchedule> schedules = schedules_;
  State sampled{t, state().bodies};
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (t < foreseen_until_[g]) {
      groups_[g].putForeseen(t, sampled.bodies);
      continue;
    }
    Group group = groups_[g];
    group.advance(state_.t, t, schedules, sampled.bodies);
    group.putStates(sampled.bodies);
  }
  return sampled;
}

void Simulation::formGroups() {
  state();  // for groups to start from
  for (const Group& group : groups_)
    if (group.choice().controlled) disturb(group.members().front());
  groups_.clear();
  group_of_.assign(world_->bodies.size(), 0);
  const std::vector<CoupledBodies> all = coupledBodies(*world_, schedules_);
  const auto trials = std::count_if(all.begin(), all.end(), [this](const CoupledBodies& bodies) {
    return bodies.members.size() > 1 || needsOf(*world_, bodies, schedules_) != 0;
  });
  const double share = std::min(1.0, kFullTrials / std::max(1.0, static_cast<double>(trials)));
  for (const CoupledBodies& bodies : all) {
    for (std::size_t body : bodies.members) group_of_[body] = groups_.size();
    MethodChoice choice = chosen(bodies, share * kMostTrialSteps);
    choice.most_turn_share = most_turn_share_;
    groups_.emplace_back(*world_, bodies, choice);
    groups_.back().restart(state_.t, schedules_);
  }
  foreseen_until_.assign(groups_.size(), kNotForeseen);
}

/// Begins anew from the present, what acts on a body or its state being another from now on.
void Simulation::restartGroup(std::size_t body) {
  const std::size_t group = group_of_[body];
  catchUp(group);
  groups_[group].restart(state_.t, schedules_);
  foreseen_until_[group] = kNotForeseen;
}

/// The row named by the scene; with auto, none where the motion can be solved, else the cheapest
/// for the motion that the scene foretells, or what follows any other.
MethodChoice Simulation::chosen(const CoupledBodies& bodies, double most_trial_steps) {
  const unsigned needs = needsOf(*world_, bodies, schedules_);
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

/// Bodies that act on one another no longer move as the scene foretold.
void Simulation::disturb(std::size_t body) {
  if (world_->bodies[body].fixed) return;
  Group& group = groups_[group_of_[body]];
  for (std::size_t member : group.members()) disturbed_[member] = true;
  group.distrustTrial();
}

void Simulation::applyWrench(const std::string& slot, const PointWrench& wrench) {
  if (wrenchCount() >= kMostWrenches)
    throw std::invalid_argument("at most " + std::to_string(kMostWrenches) +
                                " wrenches may act or be to come");
  if (method_ && !HeldWrench::holds(wrench))
    requireTaken(*method_, kCoupling, world_->bodies[wrench.body].name);
  schedules_[wrench.body].put(slot, wrench, state_.t);
  disturb(wrench.body);
  if (HeldWrench::holds(wrench))
    restartGroup(wrench.body);
  else
    formGroups();
  if (coarse_) {
    coarse_->choices_ = choices_;
    coarse_->applyWrench(slot, wrench);
  }
}

void Simulation::clearWrenches() {
  for (std::size_t body = 0; body < schedules_.size(); ++body) {
    if (schedules_[body].size() > 0) disturb(body);
    schedules_[body].clear();
  }
  formGroups();
  coarse_.reset();
}

void Simulation::clearWrenches(std::size_t body) {
  if (schedules_[body].size() > 0) disturb(body);
  schedules_[body].clear();
  formGroups();
  coarse_.reset();
}

void Simulation::clearWrenches(std::size_t body, const std::string& slot) {
  if (schedules_[body].size() > 0) disturb(body);
  schedules_[body].clear(slot);
  formGroups();
  coarse_.reset();
}

int Simulation::mostParts() const {
  int most = 1;
  for (const Group& group : groups_) most = std::max(most, group.mostParts());
  return most;
}

std::int64_t Simulation::evaluations() const {
  std::int64_t sum = 0;
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
  disturb(body);
  restartGroup(body);
  state_.bodies[body] = state;
  coarse_.reset();
  startBalance();
}

}  // namespace rigid_body_sim
