#include "dynamics/run/group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <rigid_body_sim/dynamics/drag.hpp>

namespace rigid_body_sim {
namespace {

/// Stands for an ExchangeMeter where nobody asks, and costs nothing.
struct NoMeter {
  void step(const Method&, const System&, double, const std::vector<BodyState>&) {}
  void solved(const System&, const SolvedMotion&, double, double) {}
};

}  // namespace

Group::Group(const World& world, const CoupledBodies& bodies, unsigned needs,
             const MethodChoice& choice)
    : members_(bodies.members),
      needs_(needs),
      choice_(choice),
      states_(members_.size()),
      promise_{world.solver.tolerance, world.solver.horizon} {
  if (world.solver.tolerance_stated) bound_ = promise_;
  system_.g_W = world.g_W;
  for (std::size_t body : members_) {
    system_.bodies.push_back(&world.bodies[body]);
    system_.drags |= world.bodies[body].drag.any();
  }
  for (const auto& law : bodies.laws)
    system_.laws.push_back(law->renamed([this](std::size_t body) { return localIndex(body); }));
  if (system_.laws.empty()) return;
  std::vector<Stiffness> stiffness(members_.size());
  for (const auto& law : system_.laws) law->addStiffness(system_.bodies, stiffness);
  for (const Stiffness& of_body : stiffness)
    law_rate_ = std::max({law_rate_, std::sqrt(of_body.frequency_squared), of_body.decay});
}

std::size_t Group::localIndex(std::size_t body) const {
  if (body == kWorld) return kWorld;
  const auto it = std::lower_bound(members_.begin(), members_.end(), body);
  return static_cast<std::size_t>(it - members_.begin());
}

void Group::distrustTrial() {
  if (!choice_.method || std::isinf(choice_.tried_until)) return;
  MethodChoice controlled = controlledChoice();
  controlled.most_turn_share = choice_.most_turn_share;
  controlled.holds = choice_.holds;
  choice_ = controlled;
}

void Group::restart(double t, std::vector<WrenchSchedule>& schedules) {
  for (std::size_t body : members_) schedules[body].advanceTo(t);
  gatherWrenches(schedules);
}

double Group::foreseenUntil(const std::vector<WrenchSchedule>& schedules) const {
  if (!solved_) return -std::numeric_limits<double>::infinity();
  return std::min(solved_->finiteUntil(states_[0]), schedules[members_[0]].nextEvent());
}

void Group::putForeseen(double t, std::vector<BodyState>& bodies) const {
  bodies[members_[0]] = solved_->at(t);
}

void Group::advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                    const std::vector<BodyState>& bodies) {
  NoMeter none;
  advanceMetered(t, t_end, schedules, bodies, none);
}

void Group::advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                    const std::vector<BodyState>& bodies, ExchangeMeter& meter) {
  advanceMetered(t, t_end, schedules, bodies, meter);
}

template <class Meter>
void Group::advanceMetered(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                           const std::vector<BodyState>& bodies, Meter& meter) {
  for (std::size_t k = 0; k < members_.size(); ++k) states_[k] = bodies[members_[k]];

  while (t < t_end) {
    if (choice_.cut_short && t >= choice_.tried_until) distrustTrial();
    // up to the next event, or to the end
    double t_next = t_end;
    for (std::size_t body : members_) t_next = std::min(t_next, schedules[body].nextEvent());
    if (t_next > t && choice_.method) stepInParts(t_next - t, meter);
    if (t_next > t && !choice_.method) solve(t, t_next, schedules[members_[0]].nextEvent(), meter);
    t = t_next;

    // what starts and ends there
    bool changed = false;
    for (std::size_t body : members_) changed |= schedules[body].advanceTo(t);
    if (changed && t >= choice_.tried_until) distrustTrial();
    if (changed) gatherWrenches(schedules);
  }
}

void Group::putStates(std::vector<BodyState>& bodies) const {
  for (std::size_t k = 0; k < members_.size(); ++k) bodies[members_[k]] = states_[k];
}

void Group::gatherWrenches(const std::vector<WrenchSchedule>& schedules) {
  system_.held.assign(members_.size(), HeldWrench());
  system_.coupled.clear();
  for (std::size_t body : members_) {
    for (PointWrench wrench : schedules[body].active()) {
      wrench.body = localIndex(wrench.body);
      wrench.axes = localIndex(wrench.axes);
      wrench.point_frame = localIndex(wrench.point_frame);
      if (HeldWrench::holds(wrench))
        system_.held[wrench.body].add(wrench);
      else
        system_.coupled.push_back(wrench);
    }
  }
  drag_counts_ = system_.drags && choice_.method && !choice_.method->claimsTo(kRelaxes);
  speeds_up_ = drag_counts_;
  for (const HeldWrench& held : system_.held) speeds_up_ |= !held.torqueFree();
  workspace_.wrenches_current = false;
  solved_.reset();
}

/// Evaluates the solution at t_end, anchored anew where a series ends and, after an event, at t.
template <class Meter>
void Group::solve(double t, double t_end, double next_event, Meter& meter) {
  constexpr int kMostSegments = 1000000;
  const Body& body = *system_.bodies[0];
  const HeldWrench& held = system_.held[0];
  if (!solved_) solved_.emplace(body, held, system_.g_W, t, states_[0], next_event - t, bound_);
  for (int segments = 0; !(solved_->validUntil() >= t_end); ++segments) {
    const double t_valid = solved_->validUntil();
    if (solved_->isFree())
      throw StepTooLong(
          "it has turned 1e15 rad since its last event, and no longer is its attitude "
          "known to 1e-4 rad");
    if (!(t_valid > t) || segments == kMostSegments)
      throw StepTooLong("the motion is too fast to be followed");
    meter.solved(system_, *solved_, t, t_valid);
    states_[0] = solved_->at(t_valid);
    t = t_valid;
    solved_->anchorAnew(body, held, system_.g_W, t, states_[0], next_event - t, bound_);
  }
  meter.solved(system_, *solved_, t, t_end);
  states_[0] = solved_->at(t_end);
}

double Group::partsNeeded(double h, const std::vector<BodyState>& bodies) {
  for (std::size_t k = 0; k < members_.size(); ++k) states_[k] = bodies[members_[k]];
  return std::ceil(h * fastestRate(h) / (choice_.method->most_turn * choice_.most_turn_share));
}

/// What the estimate of a step of h may reach, the motion changing at a rate: errors of attitude
/// add up over the steps to the horizon; errors of momenta, relative, grow by the angle turned by
/// then; those of a body at rest, by the time. At twice the step, in the run that tells the error,
/// it is what leaves as many parts: an estimate of order 8 grows 2⁹-fold over a step twice as long.
StepBound Group::stepBound(double h, double rate) const {
  constexpr double kRounding = 1e-14;  // some ten roundings of a step that turns by a radian
  const double share = h / promise_.horizon, turned = std::max(1.0, rate * promise_.horizon);
  const double doubled = std::pow(choice_.most_turn_share, 8);
  const StepBound follows;
  return {std::clamp(promise_.attitude * share / turned * doubled, kRounding, follows.error),
          std::min(promise_.attitude * share * share * doubled / choice_.most_turn_share,
                   follows.idle)};
}

/// [1/s] What turns, swings or decays fastest within a step of h.
double Group::fastestRate(double h) const {
  double fastest = law_rate_;
  for (std::size_t k = 0; k < states_.size(); ++k)
    fastest = std::max(fastest, angularVelocity(system_.bodies[k]->inv_I, states_[k].L_P).norm());
  for (const auto& law : system_.laws)
    fastest = std::max(fastest, law->rate({system_.bodies, states_}));
  return speeds_up_ ? std::max(fastest, rateBroughtAbout(h)) : fastest;
}

/// [1/s] What torques may spin a body up to within h, and the decay by drag at the speed that
/// steady forces may bring about: quadratic drag grows with it.
double Group::rateBroughtAbout(double h) const {
  double fastest = 0;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const Body& body = *system_.bodies[k];
    const HeldWrench& held = system_.held[k];
    const Wrench wrench = held.at(states_[k]);
    const Vector3d L_dot_P = rotateBack(states_[k].q_WP, wrench.tau_W) + wrench.tau_P;
    const Vector3d w_end_P = angularVelocity(body.inv_I, Vector3d(states_[k].L_P + h * L_dot_P));
    fastest = std::max(fastest, w_end_P.norm());
    if (!drag_counts_) continue;
    const double push = body.mass * system_.g_W.norm() + held.f_W.norm() + held.f_P.norm();
    fastest = std::max(fastest, dragRate(body, (states_[k].p_W.norm() + h * push) / body.mass));
  }
  return fastest;
}

/// One step of the method, or as many as it takes for it to follow what is fastest.
template <class Meter>
void Group::stepInParts(double h, Meter& meter) {
  const Method& method = *choice_.method;
  const double turn = h * fastestRate(h);
  const double needed = std::ceil(turn / (method.most_turn * choice_.most_turn_share));
  const double parts = std::max<double>(choice_.parts, needed);
  constexpr double kMostParts = 1e5;
  if (!(parts <= kMostParts)) {
    std::ostringstream reason;
    reason << "a step spans " << turn << " rad of its turning, swinging or slowing down, more than "
           << method.name << " follows in " << kMostParts << " parts";
    throw StepTooLong(reason.str());
  }
  if (choice_.controlled) workspace_.step_bound = stepBound(h / parts, turn / h);
  if (needed > choice_.parts) most_parts_ = std::max(most_parts_, static_cast<int>(needed));
  for (int k = 0; k < static_cast<int>(parts); ++k) {
    meter.step(method, system_, h / parts, states_);
    method.step(system_, h / parts, states_, workspace_);
  }
}

}  // namespace rigid_body_sim
