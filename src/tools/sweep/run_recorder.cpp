#include "tools/sweep/run_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "tools/common/motion_numbers.hpp"

namespace rigid_body_sim {
namespace {

bool isBeyond(const RecordDef& def, double x) { return def.below ? x < def.level : x > def.level; }

/// The greatest value of a function over an interval in which it has one maximum, by the golden
/// section.
template <class Function>
double greatest(const Function& f, double from, double to) {
  constexpr int kSections = 40;
  const double share = (std::sqrt(5.0) - 1) / 2;
  double left = to - share * (to - from), right = from + share * (to - from);
  double at_left = f(left), at_right = f(right);
  for (int i = 0; i < kSections; ++i) {
    if (at_left > at_right) {
      to = right;
      right = left;
      at_right = at_left;
      at_left = f(left = to - share * (to - from));
    } else {
      from = left;
      left = right;
      at_left = at_right;
      at_right = f(right = from + share * (to - from));
    }
  }
  return std::max(at_left, at_right);
}

}  // namespace

double Quantity::of(const Body& body_def, const BodyState& state) const {
  const BodyFrameMotion motion = toBodyFrameMotion(body_def, state);
  // scaled: squares of numbers beyond 1e154 are infinite, those of numbers below 1e-162 zero
  if (index == kMotionNumbers) return motion.v_W.stableNorm();
  if (index == kMotionNumbers + 1) return motion.w_W.stableNorm();
  return motionNumbers(motion)[index];
}

bool RunRecorder::areNeededWithin(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(),
                     [](const Record& r) { return r.def.reduction != Reduction::kAtEnd; });
}

RunRecorder::RunRecorder(const std::vector<Record>& records, const Simulation& simulation)
    : records_(records), simulation_(simulation), found_(records.size()) {}

void RunRecorder::look(double t, const State* end) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const RecordDef& def = records_[i].def;
    if (!end && def.reduction == Reduction::kAtEnd) continue;
    Found& found = found_[i];
    if (def.reduction == Reduction::kFirst && found.value) continue;
    const std::size_t b = records_[i].quantity.body;
    const double x = records_[i].quantity.of(simulation_.world().bodies[b],
                                             end ? end->bodies[b] : simulation_.body(b));
    const bool better = def.reduction == Reduction::kAtEnd ||
                        (def.reduction == Reduction::kFirst && isBeyond(def, x)) ||
                        (def.reduction == Reduction::kMax && (!found.value || x > *found.value)) ||
                        (def.reduction == Reduction::kMin && (!found.value || x < *found.value));
    if (better) {
      found.value = def.reduction == Reduction::kFirst ? t : x;
      found.before = found.last;
      found.at = t;
      found.after = 0;
    } else if (found.value && found.after == 0) {
      found.after = t;
    }
    found.last = t;
  }
}

/// Between two instants of one step, at whose start the run is.
void RunRecorder::locate(std::size_t index, const Simulation& run, double from, double to,
                         std::optional<double>& value) const {
  constexpr int kHalvings = 60;
  const auto& [def, quantity] = records_[index];
  const auto at = [&, &quantity = quantity](double t) {
    const State state = run.sample(t);
    return quantity.of(run.world().bodies[quantity.body], state.bodies[quantity.body]);
  };
  if (def.reduction == Reduction::kMax) value = std::max(*value, greatest(at, from, to));
  if (def.reduction == Reduction::kMin)
    value = std::min(*value, -greatest([&](double t) { return -at(t); }, from, to));
  if (def.reduction != Reduction::kFirst) return;
  for (int i = 0; i < kHalvings && from < to; ++i) {
    const double middle = 0.5 * (from + to);
    if (middle <= from || middle >= to) break;
    (isBeyond(def, at(middle)) ? to : from) = middle;
  }
  value = to;
}

std::vector<std::optional<double>> RunRecorder::values(Simulation run, double end) const {
  std::vector<std::optional<double>> values;
  double last = 0;
  for (const Found& found : found_) {
    values.push_back(found.value);
    if (found.value) last = std::max({last, found.at, found.after});
  }
  if (!areNeededWithin(records_)) return values;
  while (run.time() < last) {
    const double now = run.time();
    const double next =
        std::min(static_cast<double>(run.steps() + 1) * run.world().solver.time_step, end);
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const Found& found = found_[i];
      if (!found.value || records_[i].def.reduction == Reduction::kAtEnd) continue;
      const bool ends_here = found.before == now && found.at > now;
      const bool begins_here =
          found.at == now && found.after > now && records_[i].def.reduction != Reduction::kFirst;
      if (ends_here || begins_here) locate(i, run, now, next, values[i]);
    }
    if (next >= last) break;
    run.step();
  }
  return values;
}

}  // namespace rigid_body_sim
