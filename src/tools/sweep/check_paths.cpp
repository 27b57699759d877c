#include <algorithm>
#include <limits>

#include "dynamics/step_too_long.hpp"
#include "scene/message_text.hpp"
#include "scene/study/reaches.hpp"
#include "tools/common/state_at.hpp"
#include "tools/sweep/sweep_runner.hpp"

namespace rigid_body_sim {
namespace {

/// Whether two runs end in different states. Of a run that diverges nothing is known, so that it
/// counts as another.
bool differ(const World& world, const std::optional<State>& a, const std::optional<State>& b) {
  if (!a || !b) return true;
  for (std::size_t i = 0; i < a->bodies.size(); ++i) {
    if (world.bodies[i].absent) continue;
    const BodyState &s = a->bodies[i], &t = b->bodies[i];
    if (s.x_W != t.x_W || s.p_W != t.p_W || s.L_W != t.L_W || s.q_WP.coeffs() != t.q_WP.coeffs())
      return true;
  }
  return false;
}

/// Whether each value of the distribution is named, so that all of them must keep the scene's
/// rules.
bool namesItsValues(const Distribution& distribution) {
  return std::holds_alternative<ListDistribution>(distribution) ||
         std::holds_alternative<GridDistribution>(distribution);
}

/// Whether the integrators that vary, too, decide whether the value counts: not every one goes by
/// it.
bool countsBySomeIntegrator(const std::string& path, const std::vector<Varied>& vary) {
  return (path == "time_step" || path == "tolerance") &&
         std::any_of(vary.begin(), vary.end(),
                     [](const Varied& varied) { return varied.path == "integrator"; });
}

/// The scene may not state what varies beside the path.
std::string statedByOther(const std::string& path, const std::vector<Varied>& vary) {
  if (path != "integrator" && path != "tolerance") return "";
  const std::string other = path == "integrator" ? "tolerance" : "integrator";
  const bool varies = std::any_of(vary.begin(), vary.end(),
                                  [&](const Varied& varied) { return varied.path == other; });
  return varies ? "; the study varies '" + other + "', too, and so states it" : "";
}

/// Whether another path decides what starts within a run.
bool othersMoveStarts(const std::string& path, const std::vector<Varied>& vary) {
  const std::string key = ".start";
  return std::any_of(vary.begin(), vary.end(), [&](const Varied& varied) {
    const std::string& other = varied.path;
    const bool is_start =
        other.size() > key.size() && other.compare(other.size() - key.size(), key.size(), key) == 0;
    return other != path && (is_start || other == "horizon");
  });
}

/// Whether one of these wrenches or commands starts when the run has ended.
template <class Timed>
bool startsAfter(const std::vector<Timed>& all, double duration) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Timed& timed) { return timed.start >= duration; });
}

/// A world without the wrenches and commands that start when the run has ended.
World withinRun(World world, double duration) {
  const auto drop = [&](auto& all) {
    const auto isAfter = [&](const auto& timed) { return timed.start >= duration; };
    all.erase(std::remove_if(all.begin(), all.end(), isAfter), all.end());
  };
  drop(world.wrenches);
  drop(world.commands);
  return world;
}

bool differWithin(double duration, const World& a, const State& initial_a, const World& b,
                  const State& initial_b) {
  const auto has_later = [&](const World& world) {
    return startsAfter(world.wrenches, duration) || startsAfter(world.commands, duration);
  };
  if (!has_later(a) && !has_later(b)) return differInMotion(a, initial_a, b, initial_b);
  return differInMotion(withinRun(a, duration), initial_a, withinRun(b, duration), initial_b);
}

std::string text(const SceneValue& value) {
  std::string all;
  for (const SceneValue::Word& word : value.words)
    all += (all.empty() ? "" : ", ") + (word.text.empty() ? "\"\"" : word.text);
  return printable(value.is_list ? "[" + all + "]" : all);
}

}  // namespace

void SweepRunner::checkPaths() {
  for (std::size_t i = 0; i < read_backs_.size(); ++i) checkPath(i);
}

/// Values to try of a path: all that are named, else some that are likely, the likeliest first.
std::vector<SceneValue> SweepRunner::probesOf(std::size_t index) const {
  const Distribution& distribution = inputs_.study.vary[index].distribution;
  if (const auto* d = std::get_if<ListDistribution>(&distribution)) return d->values;
  if (const auto* d = std::get_if<GridDistribution>(&distribution)) return d->values;
  std::vector<SceneValue> probes;
  const auto add = [&](double x) { probes.push_back(SceneValue::of(x)); };
  if (const auto* d = std::get_if<NormalDistribution>(&distribution))
    for (const double deviations : {0.0, 0.5, -0.5, 1.0, -1.0, 2.0, -2.0, 4.0, -4.0})
      add(d->mean + deviations * d->stddev);
  else if (const auto* u = std::get_if<UniformDistribution>(&distribution))
    for (const double share : {0.5, 0.75, 0.25, 0.95, 0.05, 0.0})
      add((1 - share) * u->low + share * u->high);
  else
    for (const std::int64_t run : {0, 1})
      probes.push_back(draws_.value(index, run, scene_.own(index)));
  return probes;
}

/// The world with a value at a path; none where the scene refuses it, for the reason that the first
/// refusal is then set to.
std::optional<SweepRunner::Built> SweepRunner::builtWith(std::size_t index, const SceneValue& value,
                                                         std::string& first_refusal) {
  const auto refuse = [&](const std::exception& error) {
    if (first_refusal.empty()) first_refusal = "cannot be " + text(value) + ": " + error.what();
    return std::nullopt;
  };
  scene_.set(index, value);
  try {
    return build();
  } catch (const SceneError& error) {
    return refuse(error);
  } catch (const std::invalid_argument& error) {
    return refuse(error);
  }
}

/// The state in which its run ends; none: it has no result.
std::optional<State> SweepRunner::endOf(const Built& built) const {
  try {
    Simulation run = simulationOf(built);
    return bodiesAt(run, built.duration);
  } catch (const SimulationDiverged&) {
  } catch (const StepTooLong&) {
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

/// Whether a run goes as that of the reference does. Worlds are compared first, which is quick; but
/// for the time step and the horizon, since a motion that is solved is the same whatever they are.
bool SweepRunner::movesAlike(Reference& reference, const Built& other, const std::string& path) {
  const Built& first = reference.built;
  if (first.duration != other.duration) return false;
  const bool ends_decide =
      path == "horizon" || (path == "time_step" && !RunRecorder::areNeededWithin(records_));
  const double seen = othersMoveStarts(path, inputs_.study.vary)
                          ? std::numeric_limits<double>::infinity()
                          : first.duration;
  if (!ends_decide && differWithin(seen, first.world, first.initial, other.world, other.initial))
    return false;
  if (!reference.is_run) reference.end = endOf(first);
  reference.is_run = true;
  return !differ(first.world, reference.end, endOf(other));
}

/// Whether two of the values lead to different motions, the other paths as they are now.
bool SweepRunner::differAmong(const std::vector<SceneValue>& values, std::size_t index) {
  std::optional<Reference> first;
  std::string refusal;
  for (const SceneValue& value : values) {
    std::optional<Built> built = builtWith(index, value, refusal);
    if (!built) continue;
    if (!first)
      first = Reference{value, std::move(*built), false, std::nullopt};
    else if (!(value == first->value) &&
             !movesAlike(*first, *built, inputs_.study.vary[index].path))
      return true;
  }
  return false;
}

/// Whether the path counts where the others have what is drawn for them: the frame of a twist does
/// once the body is turned.
bool SweepRunner::reachesBesideOthers(std::size_t index, std::vector<SceneValue> values) {
  constexpr std::size_t kMaxShown = 9;
  values.resize(std::min(values.size(), kMaxShown));
  bool reaches = false;
  for (std::int64_t run = 0; run < 2 && !reaches && read_backs_.size() > 1; ++run) {
    setValues(run);
    reaches = differAmong(values, index);
  }
  for (std::size_t i = 0; i < read_backs_.size(); ++i) scene_.set(i, scene_.own(i));
  return reaches;
}

/// Whether the only value of a path is the scene's own, or moves the bodies as that does.
bool SweepRunner::isAsInTheScene(std::size_t index, const SceneValue& value, bool must_differ) {
  const SceneValue own = scene_.own(index);
  if (value == own) return true;
  return must_differ && !differAmong({own, value}, index) &&
         !reachesBesideOthers(index, {own, value});
}

void SweepRunner::checkPath(std::size_t index) {
  const Varied& varied = inputs_.study.vary[index];
  const auto fail = [&](const std::string& message) {
    throw SceneError(inputs_.study.source, varied.line,
                     oneLine("vary: '" + varied.path + "' " + message));
  };
  const auto failAtScene = [&](const std::string& why) {
    fail(why + statedByOther(varied.path, inputs_.study.vary));
  };
  const bool all_must_do = namesItsValues(varied.distribution);
  // what is under `forces` are parameters of laws, all of which act
  bool reaches = varied.path.rfind("forces", 0) == 0 ||
                 countsBySomeIntegrator(varied.path, inputs_.study.vary);
  const bool may_reach = reaches;
  bool differs = false, has_one = true;
  std::optional<Reference> first;
  std::string refusal;
  for (const SceneValue& probe : probesOf(index)) {
    if (first && reaches && !all_must_do) break;
    std::optional<Built> built = builtWith(index, probe, refusal);
    if (!built && all_must_do) failAtScene(refusal);
    if (!built) continue;
    if (!first) {
      first = Reference{probe, std::move(*built), false, std::nullopt};
      continue;
    }
    has_one &= probe == first->value;
    if (!reaches && !(probe == first->value)) {
      differs = true;
      reaches = !movesAlike(*first, *built, varied.path);
    }
  }
  if (!first) failAtScene(refusal);
  if (all_must_do && has_one && isAsInTheScene(index, first->value, !may_reach))
    fail("varies nothing: the only value, " + text(first->value) +
         ", moves the bodies as the scene's own does");
  if (differs && !reaches && !reachesBesideOthers(index, probesOf(index)))
    fail("varies nothing: the bodies move alike whether it is " + text(first->value) +
         " or not; remove it, or change in the scene what keeps it from acting");
  scene_.set(index, scene_.own(index));
}

}  // namespace rigid_body_sim
