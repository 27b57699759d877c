#include <algorithm>
#include <cmath>
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

void Simulation::step() {
  if (tracked_) return trackedStep();
  stepBy([](Group& group, auto&... between) { group.advance(between...); });
}

void Simulation::trackedStep() {
  if (balance_) {
    ExchangeMeter& meter = balance_->beginStep();
    stepBy([&](Group& group, auto&... between) { group.advance(between..., meter); });
    balance_->endStep();
  } else {
    stepBy([](Group& group, auto&... between) { group.advance(between...); });
  }
  if (tracks_error_ && steps_ % 2 == 0) followCoarse();
}

/// One step, each group by advance(group, t, t_end, schedules, bodies).
template <class Advance>
void Simulation::stepBy(const Advance& advance) {
  next_ = state_;
  next_.t = static_cast<double>(steps_ + 1) * world_->solver.time_step;
  for (Group& group : groups_) {
    try {
      advance(group, state_.t, next_.t, schedules_, next_.bodies);
    } catch (const StepTooLong& reason) {
      throw SimulationDiverged(state_.t, world_->bodies[group.members().front()].name,
                               reason.what());
    }
  }
  acceptStep();
}

/// Makes the step's end the present, where it is finite.
void Simulation::acceptStep() {
  for (std::size_t i = 0; i < next_.bodies.size(); ++i) {
    if (std::isfinite(sumOfAll(next_.bodies[i]))) continue;
    if (const char* quantity = nonFiniteQuantity(next_.bodies[i]))
      throw SimulationDiverged(state_.t, world_->bodies[i].name, quantity);
  }
  std::swap(state_, next_);
  ++steps_;
}

State Simulation::sample(double t) const {
  std::vector<WrenchSchedule> schedules = schedules_;
  State state{t, state_.bodies};
  for (Group group : groups_) group.advance(state_.t, t, schedules, state.bodies);
  return state;
}

void Simulation::formGroups() {
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
    groups_[group_of_[wrench.body]].restart(state_.t, schedules_);
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
    addPointWrench(applied, state_.bodies, wrench);
  return wrench;
}

void Simulation::setState(std::size_t body, const BodyState& state) {
  state_.bodies[body] = state;
  disturb(body);
  groups_[group_of_[body]].restart(state_.t, schedules_);
  coarse_.reset();
  startBalance();
}

}  // namespace rigid_body_sim
