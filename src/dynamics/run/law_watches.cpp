#include "dynamics/run/law_watches.hpp"

#include <algorithm>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNotKnown = -kNever;

const double* ownStates(const LawWatch& watch, const WatchedRun& run) {
  return run.law_states.data() + watch.firstState();
}

bool acts(const LawWatch& watch, const WatchedRun& run) {
  return run.world.laws[watch.law()]->acts(ownStates(watch, run));
}

/// Whether the motions of all its bodies are known beforehand.
bool isForeseen(const LawWatch& watch, const Groups& groups) {
  return std::all_of(watch.members().begin(), watch.members().end(),
                     [&](std::size_t body) { return groups.of(body).isForeseen(); });
}

/// Whether bodies of which some are integrated may touch before t_end. What acts on them is not
/// known beforehand: within the step they may reverse and double their speed, and fall twice as
/// fast.
bool isNear(const LawWatch& watch, const WatchedRun& run, double t, double t_end) {
  const double h = t_end - t;
  const auto motion = [&](std::size_t body, double at) { return run.groups.at(body, at); };
  const auto bound = [&](std::size_t body) {
    const BodyState s = motion(body, t);
    const Body& of = run.world.bodies[body];
    MotionBound loose;
    loose.a_off = 4 * s.p_W.norm() / of.mass / h + 2 * run.world.g_W.norm();
    loose.torque = (4 * s.L_P.norm() + 4 * radiusOfGyration(of) * s.p_W.norm()) / h;
    loose.until = kNever;
    return std::optional<MotionBound>(loose);
  };
  return watch.quietInFlight(t, ownStates(watch, run), motion, bound) < t_end;
}

}  // namespace

LawWatches::LawWatches(const World& world, const LawTable& laws, std::set<std::size_t> near)
    : near_(std::move(near)) {
  for (std::size_t law : laws.guarded()) watches_.emplace_back(world, law, laws.firstState(law));
  wakeUp();
}

void LawWatches::wakeUp() {
  for (LawWatch& watch : watches_) watch.wakeUp();
  quiet_until_ = watches_.empty() ? kNever : kNotKnown;
}

void LawWatches::wakeUp(const std::vector<std::size_t>& bodies) {
  for (LawWatch& watch : watches_) {
    const auto isHere = [&bodies](std::size_t body) {
      return std::binary_search(bodies.begin(), bodies.end(), body);
    };
    if (!std::any_of(watch.members().begin(), watch.members().end(), isHere)) continue;
    watch.wakeUp();
    quiet_until_ = kNotKnown;
  }
}

void LawWatches::restart() {
  near_.clear();
  wakeUp();
}

/// Whether its law does not act, nor belong to a group that looks after it.
bool LawWatches::isWatched(const LawWatch& watch, const WatchedRun& run) const {
  if (acts(watch, run)) return false;
  const Group& group = run.groups.of(watch.members().front());
  return !(group.mayStop() && group.follows(watch.law()));
}

void LawWatches::findQuiet(const WatchedRun& run) {
  quiet_until_ = kNever;
  for (const LawWatch& watch : watches_)
    if (isWatched(watch, run)) quiet_until_ = std::min(quiet_until_, watch.quietUntil());
  for (const Group& group : run.groups.all()) {
    if (group.mayStop()) quiet_until_ = kNotKnown;
    if (group.isAtRest()) quiet_until_ = std::min(quiet_until_, group.restsUntil(run.schedules));
  }
}

std::optional<LawWatches::Event> LawWatches::firstEvent(const WatchedRun& run, double t_end) {
  std::optional<Event> first;
  for (LawWatch& watch : watches_) {
    const double until = first ? first->t : t_end;
    if (until < watch.quietUntil() || !isWatched(watch, run)) continue;
    if (const std::optional<Event> event = eventOf(watch, run, until)) first = event;
  }
  return first;
}

std::optional<LawWatches::Event> LawWatches::eventOf(LawWatch& watch, const WatchedRun& run,
                                                     double t_end) const {
  double t = run.time;
  for (std::size_t body : watch.members()) t = std::max(t, run.groups.of(body).time());
  if (!(t < t_end)) return std::nullopt;
  if (watch.members().size() > 1 && !isForeseen(watch, run.groups)) {
    if (!isNear(watch, run, t, t_end)) return std::nullopt;
    return Event{&watch, t, true};
  }
  const auto bound = [&run](std::size_t body) {
    return run.groups.of(body).motionBound(run.schedules);
  };
  try {
    if (const std::optional<double> event =
            watch.firstEvent(t, t_end, ownStates(watch, run), run.motion, bound))
      return Event{&watch, *event};
  } catch (const StepTooLong& reason) {
    throw SimulationDiverged(t, run.world.bodies[watch.members().front()].name, reason.what());
  }
  return std::nullopt;
}

std::vector<std::size_t> LawWatches::forgetFar(const WatchedRun& run, double t_end) {
  std::vector<std::size_t> parted;
  for (const LawWatch& watch : watches_) {
    const auto kept = near_.find(watch.law());
    if (kept == near_.end()) continue;
    const bool still_acts = acts(watch, run);
    if (!still_acts && isNear(watch, run, run.time, t_end)) continue;
    near_.erase(kept);
    if (!still_acts) parted.insert(parted.end(), watch.members().begin(), watch.members().end());
  }
  return parted;
}

}  // namespace rigid_body_sim
