#include <algorithm>

#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"
#include "scene/study/reaches.hpp"
#include "tools/common/state_at.hpp"
#include "tools/sweep/sweep_runner.hpp"

namespace rigid_body_sim {
namespace {

/// The states in which runs end, for worlds whose difference does not show otherwise.
bool endsDiffer(const World& a, const State& initial_a, const World& b, const State& initial_b,
                double duration) {
  Simulation run_a(a, initial_a), run_b(b, initial_b);
  const State end_a = stateAt(run_a, duration), end_b = stateAt(run_b, duration);
  for (std::size_t i = 0; i < end_a.bodies.size(); ++i) {
    const BodyState &s = end_a.bodies[i], &t = end_b.bodies[i];
    if (s.x_W != t.x_W || s.p_W != t.p_W || s.L_W != t.L_W || s.q_WP.coeffs() != t.q_WP.coeffs())
      return true;
  }
  return false;
}

std::string text(const SceneValue& value) {
  std::string all;
  for (const SceneValue::Word& word : value.words) all += (all.empty() ? "" : ", ") + word.text;
  return printable(value.is_list ? "[" + all + "]" : all);
}

}  // namespace

void SweepRunner::checkPaths() {
  for (std::size_t i = 0; i < values_.size(); ++i) checkPath(i);
}

/// Values of a path that every study must be able to take: all of a list, what lies in the middle.
std::vector<SceneValue> SweepRunner::probesOf(std::size_t index) const {
  const Distribution& distribution = inputs_.study.vary[index].distribution;
  if (const auto* d = std::get_if<ListDistribution>(&distribution)) return d->values;
  if (const auto* d = std::get_if<GridDistribution>(&distribution)) return d->values;
  const auto number = [](double x) { return SceneValue{{{numberText(x)}}, false}; };
  if (const auto* d = std::get_if<NormalDistribution>(&distribution))
    return {number(d->mean), number(d->mean + 0.5 * d->stddev)};
  if (const auto* d = std::get_if<UniformDistribution>(&distribution))
    return {number(0.5 * (d->low + d->high)), number(0.75 * d->high + 0.25 * d->low)};
  return {draws_.value(index, 0, scene_.own(index)), draws_.value(index, 1, scene_.own(index))};
}

void SweepRunner::checkPath(std::size_t index) {
  constexpr std::size_t kMaxProbes = 1000;
  const Varied& varied = inputs_.study.vary[index];
  const auto fail = [&](const std::string& message) {
    throw SceneError(inputs_.study.source, varied.line,
                     oneLine("vary: '" + varied.path + "' " + message));
  };
  // what is under `forces` are parameters of laws, all of which act
  bool reaches = varied.path.rfind("forces", 0) == 0, differs = false;
  std::optional<Built> first;
  SceneValue first_value;
  const std::vector<SceneValue> probes = probesOf(index);
  for (std::size_t k = 0; k < probes.size() && k < kMaxProbes; ++k) {
    scene_.set(index, probes[k]);
    std::optional<Built> built;
    try {
      built = build();
    } catch (const SceneError& refused) {
      fail("cannot be " + text(probes[k]) + ": " + refused.what());
    }
    if (!first) {
      first = std::move(built);
      first_value = probes[k];
    } else if (!reaches && !(probes[k] == first_value)) {
      differs = true;
      reaches =
          differInMotion(first->world, first->initial, built->world, built->initial) ||
          endsDiffer(first->world, first->initial, built->world, built->initial, built->duration);
    }
  }
  if (differs && !reaches)
    fail("varies nothing: the bodies move alike whether it is " + text(first_value) + " or not");
  scene_.set(index, scene_.own(index));
}

}  // namespace rigid_body_sim
