#include "dynamics/run/law_watches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr double kNotKnown = -kForever;

const double* ownStates(const LawWatch& watch, const RunState& run) {
  return run.law_states.data() + watch.firstState();
}

bool acts(const LawWatch& watch, const RunState& run) {
  return run.world->laws[watch.law()]->acts(ownStates(watch, run));
}

/// Whether the motions of all its bodies are known beforehand.
bool isSolvedAhead(const LawWatch& watch, const Groups& groups) {
  return std::all_of(watch.members().begin(), watch.members().end(),
                     [&](std::size_t body) { return groups.of(body).isSolvedAhead(); });
}

}  // namespace

LawWatches::LawWatches(const World& world, const LawTable& laws, std::set<std::size_t> near)
    : pairs_(world, laws), near_(std::move(near)) {
  for (std::size_t law : laws.guarded()) watches_.emplace_back(world, law, laws.firstState(law));
  wakeUp();
}

template <class F>
void LawWatches::forWatches(const F& f) {
  for (LawWatch& watch : watches_) f(watch);
  for (LawWatch& watch : candidates_) f(watch);
}

void LawWatches::wakeUp() {
  forWatches([](LawWatch& watch) { watch.wakeUp(); });
  pairs_.forget();
  // NOLINTNEXTLINE(bugprone-narrowing-conversions): of infinity, from double to double
  quiet_until_ = watches_.empty() && !pairs_.hasLaws() ? kForever : kNotKnown;
}

void LawWatches::wakeUp(const std::vector<std::size_t>& bodies) {
  const auto isHere = [&bodies](std::size_t body) {
    return std::binary_search(bodies.begin(), bodies.end(), body);
  };
  forWatches([&](LawWatch& watch) {
    if (!std::any_of(watch.members().begin(), watch.members().end(), isHere)) return;
    watch.wakeUp();
    quiet_until_ = kNotKnown;
  });
  if (!pairs_.hasLaws()) return;
  pairs_.forget();
  quiet_until_ = kNotKnown;
}

bool LawWatches::findCandidates(const RunState& run, double t_end, bool looks_ahead) {
  if (!pairs_.hasLaws()) return false;
  const bool is_usable = !pairs_.lookedAhead() || (looks_ahead && run.groups.allSolvedAhead());
  if (t_end <= pairs_.until() && is_usable) return false;
  pairs_.sweep(*run.world, run.groups, run.schedules, run.time, t_end, looks_ahead);
  std::vector<LawWatch> found;
  for (std::size_t law : pairs_.candidates()) {
    if (LawWatch* known = candidate(law))
      found.push_back(*known);
    else
      found.emplace_back(*run.world, law, run.laws.firstState(law));
  }
  candidates_ = std::move(found);
  return true;
}

/// The watch of such a law; null where it is none of the candidates.
LawWatch* LawWatches::candidate(std::size_t law) {
  const auto at =
      std::lower_bound(candidates_.begin(), candidates_.end(), law,
                       [](const LawWatch& watch, std::size_t of) { return watch.law() < of; });
  return at != candidates_.end() && at->law() == law ? &*at : nullptr;
}

void LawWatches::restart(std::set<std::size_t> near) {
  near_ = std::move(near);
  wakeUp();
}

/// Whether its law does not act, nor belong to a group that looks after it.
bool LawWatches::isWatched(const LawWatch& watch, const RunState& run) const {
  if (acts(watch, run)) return false;
  const Group& group = run.groups.of(watch.members().front());
  return group.isSolvedAhead() || !group.follows(watch.law());
}

void LawWatches::findQuiet(const RunState& run) {
  quiet_until_ = pairs_.hasLaws() ? pairs_.until() : kForever;
  forWatches([&](const LawWatch& watch) {
    if (isWatched(watch, run)) quiet_until_ = std::min(quiet_until_, watch.quietUntil());
  });
  for (const Group& group : run.groups.all()) {
    if (group.mayStop()) quiet_until_ = kNotKnown;
    if (group.isAtRest()) quiet_until_ = std::min(quiet_until_, group.restsUntil(run.schedules));
  }
  if (!near_.empty()) quiet_until_ = kNotKnown;  // forgotten at the first step that can
}

std::optional<LawWatches::Event> LawWatches::firstEvent(const RunState& run, double t_end) {
  std::optional<Event> first;
  forWatches([&](LawWatch& watch) {
    const double until = first ? first->t : t_end;
    if (until < watch.quietUntil() || !isWatched(watch, run)) return;
    if (const std::optional<Event> event = eventOf(watch, run, until)) first = event;
  });
  return first;
}

/// Whether bodies of which some are integrated may touch before t_end: within how far they are
/// taken to go, where the law needs them to be near each other. For other laws, they may reverse
/// and double their speed within the step, and fall twice as fast.
bool LawWatches::isNear(const LawWatch& watch, const RunState& run, double t, double t_end) const {
  if (std::isfinite(run.world->laws[watch.law()]->touchRadius(0)))
    return watch.mayAct(ownStates(watch, run),
                        [this](std::size_t body) -> const Roam& { return pairs_.roam(body); });
  const double h = t_end - t;
  const auto motion = [&](std::size_t body, double at) { return run.groups.at(body, at); };
  const auto bound = [&](std::size_t body) {
    const BodyState s = motion(body, t);
    const Body& of = run.world->bodies[body];
    MotionBound loose;
    loose.a_off = 4 * s.p_W.norm() / of.mass / h + 2 * run.world->g_W.norm();
    loose.torque = (4 * s.L_P.norm() + 4 * radiusOfGyration(of) * s.p_W.norm()) / h;
    loose.until = kForever;
    return std::optional<MotionBound>(loose);
  };
  return watch.quietInFlight(t, ownStates(watch, run), motion, bound) < t_end;
}

std::optional<LawWatches::Event> LawWatches::eventOf(LawWatch& watch, const RunState& run,
                                                     double t_end) const {
  double t = run.time;
  for (std::size_t body : watch.members()) t = std::max(t, run.groups.of(body).time());
  if (!(t < t_end)) return std::nullopt;
  if (watch.members().size() > 1 && !isSolvedAhead(watch, run.groups)) {
    if (!isNear(watch, run, t, t_end)) return std::nullopt;
    return Event{&watch, t, true};
  }
  const auto motion = [&run](std::size_t body, double at) { return run.at(body, at); };
  const auto bound = [&run](std::size_t body) {
    return run.groups.of(body).motionBound(run.schedules);
  };
  try {
    if (const std::optional<double> event =
            watch.firstEvent(t, t_end, ownStates(watch, run), motion, bound))
      return Event{&watch, *event};
  } catch (const StepTooLong& reason) {
    throw SimulationDiverged(t, run.world->bodies[watch.members().front()].name, reason.what());
  }
  return std::nullopt;
}

std::vector<std::size_t> LawWatches::forgetFar(const RunState& run, double t_end) {
  std::vector<std::size_t> parted;
  std::set<std::size_t> kept;
  const auto consider = [&](const LawWatch& watch) {
    if (near_.erase(watch.law()) == 0) return;
    const bool still_acts = acts(watch, run);
    if (!still_acts && isNear(watch, run, run.time, t_end)) kept.insert(watch.law());
    if (!still_acts && kept.count(watch.law()) == 0)
      parted.insert(parted.end(), watch.members().begin(), watch.members().end());
  };
  forWatches(consider);
  // what is left is no candidate any more
  for (std::size_t law : near_)
    for (std::size_t body : run.world->laws[law]->members()) parted.push_back(body);
  near_ = std::move(kept);
  return parted;
}

}  // namespace rigid_body_sim
