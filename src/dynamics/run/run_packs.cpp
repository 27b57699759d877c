#include <algorithm>
#include <cmath>

#include "dynamics/run/run.hpp"

/// How bodies move between their groups and packs, and how packs are stepped.
namespace rigid_body_sim {

namespace {

const Drag* asDrag(const std::shared_ptr<const ForceLaw>& law) {
  return dynamic_cast<const Drag*>(law.get());
}

}  // namespace

std::optional<SteadyMotion> Group::steadyMotion() const {
  const Drag* drag = system_.flows.size() == 1 ? asDrag(system_.flows.front()) : nullptr;
  const bool no_other_laws =
      system_.laws.empty() && system_.stateful_laws.empty() && (system_.flows.empty() || drag);
  const bool is_steady = stepper_ && bodies_.members.size() == 1 && no_other_laws &&
                         system_.coupled.empty() && hasPackSteps(system_.held[0]) &&
                         system_.pivots.empty() && system_.driven.empty() && !isAtRest() &&
                         stepper_->takesWholeSteps();
  if (!is_steady) return std::nullopt;
  const MethodChoice& choice = stepper_->choice();
  const Body& body = *system_.bodies[0];
  return SteadyMotion{&body,
                      choice.method,
                      choice.method->max_turn * choice.max_turn_share,
                      body.mass * system_.g_W,
                      &system_.held[0],
                      drag,
                      stepper_->wrenchesCurrent(),
                      stepper_->magnification()};
}

void Group::goOnFrom(double t, const Packs::Stepped& stepped) {
  t_ = t;
  present_.bodies[0] = stepped.state;
  stepper_->goOnFrom(system_, present_, stepped);
}

void Stepper::goOnFrom(const System& system, const SystemState& states,
                       const Packs::Stepped& stepped) {
  const std::int64_t evaluations = workspace_.evaluations + stepped.evaluations;
  if (stepped.wrenches_current) evaluateWrenches(system, states, workspace_);
  workspace_.wrenches_current = stepped.wrenches_current;
  workspace_.evaluations = evaluations;
  magnification_ = stepped.magnification;
}

/// Other laws than drag look for bodies in their groups: none may be elsewhere.
void RunState::beginPacks() {
  const std::string& integrator = world->solver.integrator;
  const bool is_fit = integrator != "auto" && hasPackSteps(methodNamed(integrator)) &&
                      std::all_of(world->laws.begin(), world->laws.end(), asDrag);
  packs = is_fit ? Packs(world->bodies.size(), world->solver.time_step, world->solver.threads)
                 : Packs();
  offerAll();
}

void RunState::offerAll() {
  if (!packs.isUsed()) return;
  for (const Group& group : groups.all())
    if (group.members().size() == 1) packs.offer(group.members().front());
}

void RunState::pack(double t_end) {
  for (std::size_t body : packs.takeOffers()) {
    if (packs.holds(body)) continue;
    const std::size_t g = groups.indexOf(body);
    const double next_event = schedules[body].nextEvent();
    if (next_event <= t_end) {
      packs.offer(body);
      continue;
    }
    const std::optional<SteadyMotion> motion = groups[g].steadyMotion();
    if (motion && packs.add(body, *motion, groups[g].present().bodies[0], next_event, steps))
      groups.setElsewhere(g);
  }
}

void RunState::unpack(std::size_t body) {
  packs.offer(body);
  if (!packs.holds(body)) return;
  const std::size_t g = groups.indexOf(body);
  groups[g].goOnFrom(time, packs.steppedTo(body, steps));
  groups.findKnown(g, schedules);
  packs.remove(body);
}

void RunState::unpackAll() {
  for (std::size_t body : packs.bodies()) unpack(body);
}

void RunState::unpackEvents(double t_end) {
  if (packs.nextEvent() > t_end) return;
  for (std::size_t body : packs.withEventBy(t_end)) unpack(body);
}

void RunState::stepPacks(std::int64_t count, std::vector<BodyState>* read) {
  packs.advance(steps - count, count, read);
  if (packs.certainSteps() > 0) return;
  for (std::size_t body : packs.review()) unpack(body);
}

Group RunState::groupNow(std::size_t g) const {
  Group group = groups[g];
  const std::size_t body = group.members().front();
  if (packs.holds(body)) group.goOnFrom(time, packs.steppedTo(body, steps));
  return group;
}

MotionPlan RunState::planOf(std::size_t g) const {
  MotionPlan plan = toPlan(groups[g]);
  const std::size_t body = plan.bodies.front();
  if (packs.holds(body)) plan.evaluations += packs.steppedTo(body, steps).evaluations;
  return plan;
}

/// Packs know neither meters nor links.
void Run::preparePacks(double t_end, bool metered) {
  if (metered || grouping_.mayChangeBy(t_end)) return now_.unpackAll();
  if (now_.packs.hasOffers()) now_.pack(t_end);
  now_.unpackEvents(t_end);
}

/// How many steps may be taken with all bodies in packs and nothing to happen to any of them.
std::int64_t Run::packedSteps(std::int64_t at_most) const {
  const bool all_packed =
      now_.packs.size() > 0 && now_.packs.size() == now_.groups.size() && !now_.packs.hasOffers();
  if (!all_packed) return 0;
  std::int64_t count = std::min(at_most, now_.packs.certainSteps());
  const auto isQuiet = [this](std::int64_t steps) {
    const double t_end = static_cast<double>(now_.steps + steps) * now_.world->solver.time_step;
    return now_.packs.nextEvent() > t_end && !grouping_.mayChangeBy(t_end);
  };
  while (count > 0 && !isQuiet(count)) count /= 2;
  return count;
}

/// The last of these steps and the reading of packs are one.
void Run::step(std::int64_t count, std::vector<BodyState>* states) {
  bool is_read = false;
  if (states) states->resize(now_.world->bodies.size());
  while (count > 0) {
    const std::int64_t steps = packedSteps(count);
    if (steps == 0) {
      advance(nullptr);
    } else {
      is_read = states && steps == count;
      now_.steps += steps;
      now_.time = static_cast<double>(now_.steps) * now_.world->solver.time_step;
      now_.stepPacks(steps, is_read ? states : nullptr);
    }
    count -= std::max<std::int64_t>(1, steps);
  }
  if (!states) return;
  if (!is_read) {
    readBodies(*states, reads_backward_);
    reads_backward_ = !reads_backward_;
    return;
  }
  // all others are fixed or absent
  for (std::size_t i = 0; now_.groups.size() < states->size() && i < states->size(); ++i)
    if (!now_.groups.has(i)) (*states)[i] = now_.start->bodies[i];
}

}  // namespace rigid_body_sim
