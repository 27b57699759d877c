#include "dynamics/run/group.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "dynamics/methods/pivots.hpp"

namespace rigid_body_sim {
namespace {

/// 1e-8 of a step where no force jumps at an event; else to rounding.
double eventPrecision(const System& system) {
  constexpr double kSmooth = 1e-8;
  const auto isSmooth = [](const System::StatefulLaw& stateful) {
    return stateful.law->guardCount() == 0 || stateful.law->switchesSmoothly();
  };
  return std::all_of(system.stateful_laws.begin(), system.stateful_laws.end(), isSmooth) ? kSmooth
                                                                                         : 0;
}

}  // namespace

Group::Group(const World& world, const LawTable& laws, const CoupledBodies& bodies,
             const MethodChoice& choice, double t, std::vector<BodyState> start,
             const std::vector<double>& law_states, const std::vector<WrenchSchedule>& schedules)
    : bodies_(bodies), present_{std::move(start), {}}, solved_choice_(choice), t_(t) {
  const ErrorBound tolerance{world.solver.tolerance, world.solver.horizon};
  // impacts and pulls magnify errors of the flights before them, so that these are solved to
  // rounding
  if (world.solver.tolerance_stated && laws.oneSided().empty()) bound_ = tolerance;
  system_.g_W = world.g_W;
  for (std::size_t body : bodies_.members) system_.bodies.push_back(&world.bodies[body]);
  addLaws(world, bodies.laws, laws, law_states);
  if (choice.method && !bodies.waiting.empty()) addLaws(world, bodies.waiting, laws, law_states);
  addPivots(world);
  addActuators(schedules);
  if (system_.has_contact) system_.event_precision = eventPrecision(system_);
  if (choice.method) stepper_.emplace(choice, tolerance, system_);
  gatherWrenches(schedules);
  next_ = present_;
}

/// Parts the laws by what they ask of an integrator.
void Group::addLaws(const World& world, const std::vector<std::size_t>& laws, const LawTable& table,
                    const std::vector<double>& law_states) {
  for (std::size_t index : laws) {
    auto law = world.laws[index]->reindexed([this](std::size_t body) { return localIndex(body); });
    system_.law_states_change |= (law->needs() & kLawStates) != 0;
    system_.has_events |= law->guardCount() > 0;
    system_.has_contact |= (law->needs() & kContact) != 0;
    if (law->stateCount() > 0) {
      const double* own = law_states.data() + table.firstState(index);
      const std::size_t first = present_.laws.size();
      present_.laws.insert(present_.laws.end(), own, own + law->stateCount());
      system_.stateful_laws.push_back({std::move(law), first});
      stateful_laws_.push_back(index);
    } else if (law->hasFlow()) {
      system_.flow_of.resize(bodies_.members.size());
      system_.flow_of[law->members().front()] = law.get();
      system_.flows.push_back(std::move(law));
    } else {
      system_.laws.push_back(std::move(law));
    }
  }
}

void Group::addPivots(const World& world) {
  for (std::size_t k = 0; k < system_.bodies.size(); ++k)
    if (system_.bodies[k]->pivoted) system_.pivots.push_back({k, world.g_W});
  if (!system_.pivots.empty() && system_.bodies.size() == 1) system_.g_W.setZero();
}

void Group::putLawStates(const LawTable& table, std::vector<double>& law_states) const {
  for (std::size_t k = 0; k < stateful_laws_.size(); ++k) {
    const System::StatefulLaw& stateful = system_.stateful_laws[k];
    std::copy_n(
        present_.laws.begin() + static_cast<std::ptrdiff_t>(stateful.first),
        stateful.law->stateCount(),
        law_states.begin() + static_cast<std::ptrdiff_t>(table.firstState(stateful_laws_[k])));
  }
}

std::size_t Group::localIndex(std::size_t body) const {
  if (body == kWorld) return kWorld;
  const auto it = std::lower_bound(bodies_.members.begin(), bodies_.members.end(), body);
  return static_cast<std::size_t>(it - bodies_.members.begin());
}

void Group::anchor(const MotionAnchor& anchor) {
  anchored_until_ = anchor.horizon;
  solved_.emplace(problem(), anchor.t, anchor.state, anchored_until_);
  t_ = anchor.t;
  present_.bodies[0] = anchor.state;
}

void Group::anchorHere(const std::vector<WrenchSchedule>& schedules) {
  anchor({t_, present_.bodies[0], nextEvent(schedules)});
}

void Group::fallBackToErrorControl() {
  if (stepper_) stepper_->fallBackToErrorControl();
}

void Group::restart(double t, const std::vector<WrenchSchedule>& schedules) {
  if (solved_) present_.bodies[0] = solved_->at(t);
  t_ = t;
  solved_.reset();
  gatherWrenches(schedules);
}

void Group::setState(std::size_t k, const BodyState& state) {
  solved_.reset();
  present_.bodies[k] = state;
  if (stepper_) stepper_->restart(system_);
}

double Group::knownUntil(const std::vector<WrenchSchedule>& schedules) const {
  if (!solved_) return -std::numeric_limits<double>::infinity();
  return std::min(solved_->finiteUntil(present_.bodies[0]), nextEvent(schedules));
}

double Group::nextEvent(const std::vector<WrenchSchedule>& schedules) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t body : bodies_.members) next = std::min(next, schedules[body].nextEvent());
  return next;
}

MotionAnchor Group::anchorOf(std::size_t k) const {
  constexpr double kNotSolved = -std::numeric_limits<double>::infinity();
  if (!solved_) return {t_, present_.bodies[k], kNotSolved};
  MotionAnchor anchor = solved_->anchor();
  anchor.horizon = anchored_until_;
  return anchor;
}

void Group::gatherWrenches(const std::vector<WrenchSchedule>& schedules) {
  system_.coupled.clear();
  system_.held.clear();
  system_.held.reserve(bodies_.members.size());
  auto pivot = system_.pivots.begin();
  const auto isHere = [this](std::size_t frame) {
    return frame == kWorld ||
           std::binary_search(bodies_.members.begin(), bodies_.members.end(), frame);
  };
  for (std::size_t k = 0; k < bodies_.members.size(); ++k) {
    HeldWrenchSum sum;
    for (PointWrench wrench : schedules[bodies_.members[k]].active()) {
      if (HeldWrench::holds(wrench)) {
        sum.add(wrench);
      } else if (isHere(wrench.axes) && isHere(wrench.point_frame)) {
        wrench.body = k;
        wrench.axes = localIndex(wrench.axes);
        wrench.point_frame = localIndex(wrench.point_frame);
        system_.coupled.push_back(wrench);
      }  // else its bodies are about to be linked
    }
    const bool on_pivot = pivot != system_.pivots.end() && pivot->body == k;
    system_.held.push_back(on_pivot ? heldOnPivot(*system_.bodies[k], sum, *pivot) : sum.sum());
    if (on_pivot) ++pivot;
  }
  if (!system_.driven.empty()) gatherActuators(schedules);
  const bool no_laws =
      system_.laws.empty() && system_.flows.empty() && system_.stateful_laws.empty();
  if (!no_laws && !stepper_) gatherMedium();
  system_.torque_free = no_laws && system_.coupled.empty() &&
                        std::all_of(system_.held.begin(), system_.held.end(),
                                    [](const HeldWrench& held) { return held.torqueFree(); });
  if (stepper_) stepper_->restart(system_);
}

void Group::advance(double t, double t_end, std::vector<WrenchSchedule>& schedules) {
  NoMeter none;
  advanceMetered(t, t_end, schedules, none);
}

void Group::advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                    ExchangeMeter& meter) {
  advanceMetered(t, t_end, schedules, meter);
}

template <class Meter>
void Group::advanceMetered(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                           Meter& meter) {
  std::copy(present_.bodies.begin(), present_.bodies.end(), next_.bodies.begin());
  if (!present_.laws.empty()) {
    next_.laws = present_.laws;
    setClocks(t, next_.laws);
  }
  switched_ = false;
  if (solved_ && t >= t_end) next_.bodies[0] = solved_->at(t_end);  // present_ may be older
  while (t < t_end) {
    if (t >= choice().tried_until) fallBackToErrorControl();
    // up to the next event, or to the end
    const double next_event = nextEvent(schedules);
    const double t_next = std::min(t_end, next_event);
    if (t_next > t && stepper_ && stepper_->advance(system_, t, t_next - t, next_, meter)) {
      switched_ = true;
      if (system_.has_contact) return;
    }
    if (t_next > t && !stepper_) solve(t, t_next, next_event, meter);
    t = t_next;

    // what starts and ends there
    bool changed = false;
    for (std::size_t body : bodies_.members) changed |= schedules[body].advanceTo(t);
    if (!changed) continue;
    keepMotion();
    solved_.reset();
    gatherWrenches(schedules);
    setClocks(t, next_.laws);
  }
}

/// Evaluates the solution at t_end, anchored anew where a series ends and, after an event, at t.
template <class Meter>
void Group::solve(double t, double t_end, double next_event, Meter& meter) {
  if (!solved_) {
    keepMotion();
    solved_.emplace(problem(), t, next_.bodies[0], next_event);
    anchored_until_ = next_event;
  } else if (!(solved_->validUntil() >= t_end)) {
    keepMotion();
    anchored_until_ = next_event;
  }
  followSolved(problem(), t, t_end, next_event, *solved_,
               [&]([[maybe_unused]] const SolvedMotion& motion, [[maybe_unused]] double from,
                   [[maybe_unused]] double to) {
                 if constexpr (!std::is_same_v<Meter, NoMeter>)
                   forSmoothPieces(motion, from, to, [&](double begin, double end) {
                     meter(MotionPiece(system_, motion, next_.laws, begin, end));
                   });
               });
  next_.bodies[0] = solved_->at(t_end);
}

/// Before the motion changes for the first time in a step.
void Group::keepMotion() {
  if (kept_) return;
  kept_ = Kept{std::nullopt, anchored_until_};
  if (solved_) kept_->anchor = solved_->anchor();
}

void Group::accept(double t_end) {
  t_ = t_end;
  std::swap(present_, next_);
  kept_.reset();
}

void Group::rollBack(const std::vector<WrenchSchedule>& schedules) {
  gatherWrenches(schedules);
  if (!kept_) return;
  solved_.reset();
  if (kept_->anchor)
    solved_.emplace(problem(), kept_->anchor->t, kept_->anchor->state, kept_->next_event);
  anchored_until_ = kept_->next_event;
  kept_.reset();
}

}  // namespace rigid_body_sim
