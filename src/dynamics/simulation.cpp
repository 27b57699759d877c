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

}  // namespace

SimulationDiverged::SimulationDiverged(double t, const std::string& b, const std::string& q)
    : std::runtime_error(divergedMessage(t, b, q)), time(t), body(b), quantity(q) {}

Simulation::Simulation(World world, State initial)
    : world_(std::make_shared<const World>(std::move(world))),
      initial_(std::make_shared<const State>(std::move(initial))),
      method_(&methodNamed(world_->solver.integrator == "auto" ? "strang"
                                                               : world_->solver.integrator)) {
  reset(true);
}

void Simulation::reset(bool restart_time) {
  if (restart_time) steps_ = 0;
  state_ = *initial_;
  state_.t = static_cast<double>(steps_) * world_->solver.time_step;
  schedules_.assign(world_->bodies.size(), WrenchSchedule());
  if (restart_time)
    for (const AppliedWrench& wrench : world_->wrenches)
      schedules_[wrench.body].put("", wrench, state_.t);
  formGroups();
}

void Simulation::step() {
  next_ = state_;
  next_.t = static_cast<double>(steps_ + 1) * world_->solver.time_step;
  for (Group& group : groups_) {
    try {
      advance(group, next_.t, next_);
    } catch (const StepTooLong& reason) {
      throw SimulationDiverged(state_.t, world_->bodies[group.members.front()].name, reason.what());
    }
  }
  for (std::size_t i = 0; i < next_.bodies.size(); ++i)
    if (const char* quantity = nonFiniteQuantity(next_.bodies[i]))
      throw SimulationDiverged(state_.t, world_->bodies[i].name, quantity);
  std::swap(state_, next_);
  ++steps_;
}

State Simulation::sample(double t) const {
  Simulation copy(*this);
  for (Group& group : copy.groups_) copy.advance(group, t, copy.state_);
  copy.state_.t = t;
  return std::move(copy.state_);
}

/// Steps a group from state_.t to t_end, split at every instant at which a wrench starts or ends.
void Simulation::advance(Group& group, double t_end, State& state) {
  scratch_.clear();
  for (std::size_t body : group.members) scratch_.push_back(state.bodies[body]);

  double t = state_.t;
  while (t < t_end) {
    double t_next = t_end;
    for (std::size_t body : group.members) t_next = std::min(t_next, schedules_[body].nextEvent());
    if (t_next > t) stepInParts(group, t_next - t);
    t = t_next;
    takeEvents(group, t);
  }

  for (std::size_t k = 0; k < group.members.size(); ++k)
    state.bodies[group.members[k]] = scratch_[k];
}

/// One step of the method, or as many as it takes for it to follow the turn of the fastest body.
void Simulation::stepInParts(Group& group, double h) {
  double turn = 0;
  for (std::size_t k = 0; k < scratch_.size(); ++k)
    turn =
        std::max(turn, h * angularVelocity(group.system.bodies[k]->inv_I, scratch_[k].L_P).norm());
  const double parts = std::max(1.0, std::ceil(turn / method_->most_turn));
  constexpr double kMostParts = 1e5;
  if (!(parts <= kMostParts)) {
    std::ostringstream reason;
    reason << "a step turns the body by " << turn << " rad, more than " << method_->name
           << " follows in " << kMostParts << " parts";
    throw StepTooLong(reason.str());
  }
  if (parts > 1) most_parts_ = std::max(most_parts_, static_cast<int>(parts));
  for (int k = 0; k < static_cast<int>(parts); ++k)
    method_->step(group.system, h / parts, scratch_, group.workspace);
}

void Simulation::takeEvents(Group& group, double t) {
  bool changed = false;
  for (std::size_t body : group.members) changed |= schedules_[body].advanceTo(t);
  if (changed) gatherWrenches(group);
}

void Simulation::gatherWrenches(Group& group) {
  const auto localIndex = [&group](std::size_t body) {
    if (body == kWorld) return kWorld;
    const auto it = std::lower_bound(group.members.begin(), group.members.end(), body);
    return static_cast<std::size_t>(it - group.members.begin());
  };
  System& system = group.system;
  system.held.assign(group.members.size(), HeldWrench());
  system.coupled.clear();
  for (std::size_t body : group.members) {
    for (AppliedWrench wrench : schedules_[body].active()) {
      wrench.body = localIndex(wrench.body);
      wrench.axes = localIndex(wrench.axes);
      wrench.point_frame = localIndex(wrench.point_frame);
      if (HeldWrench::holds(wrench))
        system.held[wrench.body].add(wrench);
      else
        system.coupled.push_back(wrench);
    }
  }
  group.workspace.wrenches_current = false;
}

void Simulation::formGroups() {
  groups_.clear();
  group_of_.assign(world_->bodies.size(), 0);
  std::vector<std::vector<std::size_t>> bonds;
  for (const WrenchSchedule& schedule : schedules_) bonds.push_back(schedule.bodies());
  for (std::vector<std::size_t>& members : coupledGroups(world_->bodies, bonds)) {
    Group group;
    group.members = std::move(members);
    group.system.g_W = world_->g_W;
    for (std::size_t body : group.members) {
      group.system.bodies.push_back(&world_->bodies[body]);
      group_of_[body] = groups_.size();
      schedules_[body].advanceTo(state_.t);
    }
    gatherWrenches(group);
    groups_.push_back(std::move(group));
  }
}

void Simulation::applyWrench(const std::string& slot, const AppliedWrench& wrench) {
  schedules_[wrench.body].put(slot, wrench, state_.t);
  if (isCoupled(wrench))
    formGroups();
  else
    takeEvents(groups_[group_of_[wrench.body]], state_.t);
}

void Simulation::clearWrenches() {
  for (std::size_t body = 0; body < schedules_.size(); ++body) schedules_[body].clear();
  formGroups();
}

void Simulation::clearWrenches(std::size_t body) {
  schedules_[body].clear();
  formGroups();
}

void Simulation::clearWrenches(std::size_t body, const std::string& slot) {
  schedules_[body].clear(slot);
  formGroups();
}

std::size_t Simulation::wrenchCount() const {
  std::size_t count = 0;
  for (const WrenchSchedule& schedule : schedules_) count += schedule.size();
  return count;
}

Wrench Simulation::appliedWrench(std::size_t body) const {
  Wrench wrench;
  for (const AppliedWrench& applied : schedules_[body].active())
    addAppliedWrench(applied, state_.bodies, wrench);
  return wrench;
}

void Simulation::setState(std::size_t body, const BodyState& state) {
  state_.bodies[body] = state;
  formGroups();
}

}  // namespace rigid_body_sim
