#include "dynamics/run/event_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "math/parabola.hpp"

namespace rigid_body_sim {
namespace {

bool anyBelow(const std::vector<double>& guards) {
  return std::any_of(guards.begin(), guards.end(), [](double guard) { return guard < 0; });
}

double potentialOf(const ForceLaw& law, const ForceLaw::Bodies& at) {
  return law.acts(at.own) ? law.potentialEnergy(at) : 0;
}

}  // namespace

void EventSearch::setGuards(const System& system, const SystemState& states,
                            std::vector<double>& guards) {
  guards.clear();
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    const std::size_t first = guards.size();
    guards.resize(first + law.guardCount());
    if (law.guardCount() > 0) law.setGuards(at, guards.data() + first);
  });
}

/// Sets trial_ and guards_ to a time of the piece, in eighths; whether a guard is below zero there.
bool EventSearch::isBelowAt(const MotionPiece& piece, double eighths) {
  piece.at(piece.start() + eighths * (piece.end() - piece.start()) / kEighths, trial_);
  setGuards(piece.system(), trial_, guards_);
  return anyBelow(guards_);
}

/// A time, in eighths, at which a guard is below zero; else the end. trial_ and guards_ are of that
/// time. By the motion itself at quarters of the piece and, where a guard comes near zero, at
/// eighths and between them. cubic: in its place, where that is not null, and the motion only where
/// it is below zero or nearly so.
double EventSearch::suspected(const MotionPiece& piece, const CubicBetween* cubic) {
  const auto seemsBelowAt = [&](double eighths) {
    if (!cubic) return isBelowAt(piece, eighths);
    cubic->at(eighths / kEighths, trial_);
    setGuards(piece.system(), trial_, guards_);
    return anyBelow(guards_);
  };
  constexpr std::array<std::size_t, 7> kOrder{2, 4, 6, 1, 3, 5, 7};
  for (const std::size_t k : kOrder) {
    if (k == 1 && !comesNear()) return kEighths;
    const auto eighths = static_cast<double>(k);
    const bool seems_below = seemsBelowAt(eighths);
    samples_[k] = guards_;
    if (seems_below && (!cubic || isBelowAt(piece, eighths))) return eighths;
  }
  for (std::size_t i = 0; i < samples_.front().size(); ++i) {
    const double eighths = cubic ? belowVertex(piece, i) : belowBetween(piece, i);
    if (eighths < kEighths) return eighths;
  }
  return kEighths;
}

/// By the vertices of parabolas through the samples of guard i, which a cubic has made.
double EventSearch::belowVertex(const MotionPiece& piece, std::size_t i) {
  for (std::size_t k = 1; k < kEighths; ++k) {
    const double before = samples_[k - 1][i], here = samples_[k][i], after = samples_[k + 1][i];
    if (!(here <= before && here <= after && before + after > 2 * here)) continue;
    const auto eighths = static_cast<double>(k);
    const auto [vertex, least] =
        vertexOf({eighths - 1, before}, {eighths, here}, {eighths + 1, after});
    if (isNearZero(i, least) && isBelowAt(piece, vertex)) return vertex;
  }
  return kEighths;
}

/// By the minima of the polynomial through the samples of guard i, also within the first and the
/// last eighth. Where that errs by as much as it is above zero, by a parabola around the minimum.
double EventSearch::belowBetween(const MotionPiece& piece, std::size_t i) {
  constexpr double kAround = 0.1;  // eighths
  constexpr double kErrs = 4;      // of what is seen of its error, there may be elsewhere
  EighthsInterpolant::Values values;
  for (std::size_t k = 0; k <= kEighths; ++k) values[k] = samples_[k][i];
  for (const auto& [eighths, value] : EighthsInterpolant(values).minima()) {
    if (!isNearZero(i, value)) continue;
    if (isBelowAt(piece, eighths)) return eighths;
    const double here = guards_[i];
    if (here > kErrs * std::abs(here - value)) continue;
    const double from = std::max(eighths - kAround, 0.0);
    const double to = std::min(eighths + kAround, static_cast<double>(kEighths));
    if (isBelowAt(piece, from)) return from;
    const double before = guards_[i];
    if (isBelowAt(piece, to)) return to;
    const double after = guards_[i];
    const double vertex = vertexOf({from, before}, {eighths, here}, {to, after}).x;
    if (vertex > from && vertex < to && isBelowAt(piece, vertex)) return vertex;
  }
  return kEighths;
}

/// Whether that may be below zero of guard i, for all that a cubic or a polynomial tells.
bool EventSearch::isNearZero(std::size_t i, double least) const {
  constexpr double kErrs = 0.02;  // of the greatest value, where steps are long
  double greatest = 0;
  for (const std::vector<double>& guards : samples_) greatest = std::max(greatest, guards[i]);
  return least < kErrs * greatest;
}

/// Whether a guard may come near zero, by its samples at quarters of the piece: where it falls
/// below half of the greatest of them, the quartic through them tells whether it falls below a
/// fifth at eighths. Else that cannot be.
bool EventSearch::comesNear() const {
  constexpr double kNear = 0.2, kMayComeNear = 0.5;
  for (std::size_t i = 0; i < samples_.front().size(); ++i) {
    const double a = samples_[0][i], b = samples_[2][i], c = samples_[4][i], d = samples_[6][i],
                 e = samples_[8][i];
    const double least = std::min({a, b, c, d, e}), greatest = std::max({a, b, c, d, e});
    if (!(least < kMayComeNear * greatest)) continue;
    const double between = std::min({35 * a + 140 * b - 70 * c + 28 * d - 5 * e,
                                     -5 * a + 60 * b + 90 * c - 20 * d + 3 * e,
                                     3 * a - 20 * b + 90 * c + 60 * d - 5 * e,
                                     -5 * a + 28 * b - 70 * c + 140 * d + 35 * e}) /
                           128;
    if (std::min(least, between) < kNear * greatest) return true;
  }
  return false;
}

double EventSearch::firstEvent(const MotionPiece& piece, const SystemState& at_start,
                               SystemState& at_end, const CubicBetween* cubic, bool goes_on) {
  found_ = false;
  samples_.resize(kEighths + 1);
  if (goes_on)
    std::swap(samples_.front(), samples_.back());
  else
    setGuards(piece.system(), at_start, samples_.front());
  setGuards(piece.system(), at_end, samples_.back());
  double after = piece.end();
  if (anyBelow(samples_.back())) {
    guards_ = samples_.back();
  } else {
    const double eighths = suspected(piece, cubic);
    if (eighths == kEighths) return after;
    after = piece.start() + eighths * (piece.end() - piece.start()) / kEighths;
    at_end = trial_;
  }
  found_ = true;
  scales_.resize(guards_.size());
  std::transform(guards_.begin(), guards_.end(), scales_.begin(),
                 [](double guard) { return guard < 0 ? -guard : 0; });
  guards_ = samples_.front();
  return locate(piece, piece.start(), after, at_end, cubic);
}

/// The least of the guards, each as a share of what it has at the end; above zero, of those that
/// are below zero there.
double EventSearch::lowest(const System& system, const SystemState& states) {
  setGuards(system, states, guards_);
  return lowestShare();
}

double EventSearch::lowestShare() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    if (scales_[i] > 0) least = std::min(least, guards_[i] / scales_[i]);
    if (guards_[i] < 0 && !(scales_[i] > 0)) least = std::min(least, -1.0);
  }
  return least;
}

/// Where the guards fall below zero on a cubic between two times of its piece, roughly, and how
/// fast there. No time where the cubic does not show it.
EventSearch::Crossing EventSearch::crossingOn(const CubicBetween& cubic, const MotionPiece& piece,
                                              double before, double after, double low) {
  constexpr int kMaxLooks = 6;
  constexpr double kRoughly = 1e-4;  // of the bracket: no cubic is nearer
  const double width = after - before, start = before;
  double high = -1;
  Crossing crossing;
  for (int look = 0; look < kMaxLooks; ++look) {
    const double middle = before + (after - before) * low / (low - high);
    if (!(middle > before && middle < after)) break;
    cubic.at((middle - piece.start()) / (piece.end() - piece.start()), trial_);
    const double here = lowest(piece.system(), trial_);
    const bool is_below = here < 0;
    // by the chord on the side that it shortens
    crossing.slope = is_below ? (here - low) / (middle - before) : (high - here) / (after - middle);
    crossing.t = middle - here / crossing.slope;
    if (!(std::abs(crossing.t - middle) > kRoughly * width)) break;
    (is_below ? after : before) = middle;
    (is_below ? high : low) = here;
  }
  if (!(crossing.slope < 0 && crossing.t > start)) return {};
  return crossing;
}

/// Each trial is a shorter step: first where the cubic shows the event, then by secants, until the
/// last trial lies beyond the event by less than the precision. Where that takes long, by regula
/// falsi (Illinois), and by halves where that gains too little. The sign of all guards decides, so
/// that the bracket is certain whatever they do. guards_: at the start.
double EventSearch::locate(const MotionPiece& piece, double before, double after,
                           SystemState& at_end, const CubicBetween* cubic) {
  const double precision = piece.system().event_precision * (piece.end() - piece.start());
  double low = lowestShare(), high = -1, last_width = after - before;
  Crossing crossing;
  if (cubic) crossing = crossingOn(*cubic, piece, before, after, low);
  double last = std::numeric_limits<double>::quiet_NaN(), lowest_last = 0;
  constexpr int kMaxSecants = 5;
  int kept = 0;  // how often the same end stayed, and which
  for (int trial = 1; after - before > precision; ++trial) {
    const double width = after - before;
    const bool slow = trial % 3 == 0 && width > 0.5 * last_width;
    if (trial % 3 == 0) last_width = width;
    // off the ends, so that both of them move
    const double nudge = 0.5 * precision;
    const bool by_secant = trial <= kMaxSecants && crossing.slope < 0;
    double middle =
        by_secant ? crossing.t + nudge : before + width * std::clamp(low / (low - high), 0.0, 1.0);
    if (by_secant && !(middle > before && middle < after)) middle = before + 0.5 * width;
    middle = std::clamp(middle, before + nudge, after - nudge);
    if ((slow && !by_secant) || !(middle > before && middle < after)) middle = before + 0.5 * width;
    if (!(middle > before && middle < after)) break;
    piece.at(middle, trial_);
    const double here = lowest(piece.system(), trial_);
    if (by_secant) {
      if (trial > 1) crossing.slope = (here - lowest_last) / (middle - last);
      crossing.t = middle - here / crossing.slope;
      last = middle;
      lowest_last = here;
    }
    if (here < 0) {
      after = middle;
      high = here;
      kept = std::min(kept, 0) - 1;
      if (kept < -1) low *= 0.5;
      std::swap(at_end, trial_);
      if (by_secant && trial > 1 && crossing.slope < 0 && middle - crossing.t <= precision) break;
    } else {
      before = middle;
      low = here;
      kept = std::max(kept, 0) + 1;
      if (kept > 1) high *= 0.5;
    }
  }
  return after;
}

double switchModes(const System& system, SystemState& states, std::vector<ContactEvent>& events) {
  double energy = 0;
  std::vector<double> guards, before;
  for (const System::StatefulLaw& stateful : system.stateful_laws) {
    const ForceLaw& law = *stateful.law;
    double* own = states.laws.data() + stateful.first;
    const ForceLaw::Bodies at{system.bodies, states.bodies, own};
    guards.resize(law.guardCount());
    before.assign(own, own + law.stateCount());
    const std::size_t most = 100 + 4 * guards.size();
    for (std::size_t switches = 0; !guards.empty(); ++switches) {
      law.setGuards(at, guards.data());
      const auto below =
          std::find_if(guards.begin(), guards.end(), [](double guard) { return guard < 0; });
      if (below == guards.end()) break;
      if (switches == most)
        throw StepTooLong(std::string("the modes of a ") + law.name() + " switch without end");
      energy -= potentialOf(law, at);
      law.switchMode(static_cast<std::size_t>(below - guards.begin()), at, own);
      energy += potentialOf(law, at);
    }
    law.addContactEvents(at, before.data(), events);
  }
  return energy;
}

}  // namespace rigid_body_sim
