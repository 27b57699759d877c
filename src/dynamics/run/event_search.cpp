#include "dynamics/run/event_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace rigid_body_sim {
namespace {

double potentialOf(const ForceLaw& law, const ForceLaw::Bodies& at) {
  return law.acts(at.own) ? law.potentialEnergy(at) : 0;
}

/// Cubic through place and velocity at both ends of a substep of h, at a share s of it; attitudes
/// and momenta straight. Near enough to tell where to look.
BodyState between(const Body& body, const BodyState& a, const BodyState& b, double h, double s) {
  const double s2 = s * s, s3 = s2 * s;
  BodyState state = a;
  const Vector3d gap = (b.x_W - a.x_W) + (b.x_low_W - a.x_low_W);
  state.x_low_W +=
      (3 * s2 - 2 * s3) * gap + h / body.mass * ((s3 - 2 * s2 + s) * a.p_W + (s3 - s2) * b.p_W);
  state.q_WP = a.q_WP.slerp(s, b.q_WP);
  state.p_W = (1 - s) * a.p_W + s * b.p_W;
  state.L_P = (1 - s) * a.L_P + s * b.L_P;
  state.L_W = (1 - s) * a.L_W + s * b.L_W;
  return state;
}

/// Whether nothing but a look at the guards shows events. Contact is stepped by its own error
/// estimates.
bool needCloseLook(const System& system) {
  return std::any_of(system.stateful_laws.begin(), system.stateful_laws.end(),
                     [](const System::StatefulLaw& stateful) {
                       return stateful.law->guardCount() > 0 && !(stateful.law->needs() & kContact);
                     });
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

bool EventSearch::anyBelow(const System& system, const SystemState& states) {
  setGuards(system, states, guards_);
  return std::any_of(guards_.begin(), guards_.end(), [](double guard) { return guard < 0; });
}

/// A time at which a guard is below zero, by what lies between the ends; else the end.
double EventSearch::suspected(const MotionPiece& piece, const SystemState& at_start,
                              const SystemState& at_end) {
  if (needCloseLook(piece.system())) return lookedAtClosely(piece, at_start, at_end);
  const double h = piece.end() - piece.start();
  for (const double share : {0.25, 0.5, 0.75}) {
    trial_.laws = at_end.laws;
    trial_.bodies.clear();
    for (std::size_t i = 0; i < at_end.bodies.size(); ++i)
      trial_.bodies.push_back(
          between(*piece.system().bodies[i], at_start.bodies[i], at_end.bodies[i], h, share));
    if (anyBelow(piece.system(), trial_)) return piece.start() + share * h;
  }
  return piece.end();
}

/// A time at which a guard is below zero, by the motion itself at quarters of the piece and, where
/// a guard comes near zero, at eighths and at the vertex of the parabola through the least of these
/// and its neighbours; else the end.
double EventSearch::lookedAtClosely(const MotionPiece& piece, const SystemState& at_start,
                                    const SystemState& at_end) {
  constexpr std::size_t kParts = 8;
  const double part = (piece.end() - piece.start()) / kParts;
  samples_.resize(kParts + 1);
  setGuards(piece.system(), at_start, samples_.front());
  setGuards(piece.system(), at_end, samples_.back());
  const auto isBelowAt = [&](double parts) {
    piece.at(piece.start() + parts * part, trial_);
    return anyBelow(piece.system(), trial_);
  };
  for (const std::size_t k : {2, 4, 6, 1, 3, 5, 7}) {
    if (k == 1 && !comeNear({0, 2, 4, 6, 8})) return piece.end();
    const auto parts = static_cast<double>(k);
    if (isBelowAt(parts)) return piece.start() + parts * part;
    samples_[k] = guards_;
  }
  for (std::size_t i = 0; i < samples_.front().size(); ++i) {
    for (std::size_t k = 1; k < kParts; ++k) {
      const double before = samples_[k - 1][i], here = samples_[k][i], after = samples_[k + 1][i];
      if (!(here <= before && here <= after && before + after > 2 * here)) continue;
      const double vertex = 0.5 * (before - after) / (before + after - 2 * here);
      const double parts = static_cast<double>(k) + vertex;
      if (isBelowAt(parts)) return piece.start() + parts * part;
    }
  }
  return piece.end();
}

/// Whether a guard falls below half of its greatest value among those samples.
bool EventSearch::comeNear(std::initializer_list<std::size_t> samples) const {
  constexpr double kNear = 0.5;
  for (std::size_t i = 0; i < samples_.front().size(); ++i) {
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    for (const std::size_t k : samples) {
      least = std::min(least, samples_[k][i]);
      greatest = std::max(greatest, samples_[k][i]);
    }
    if (least < kNear * greatest) return true;
  }
  return false;
}

double EventSearch::firstEvent(const MotionPiece& piece, const SystemState& at_start,
                               SystemState& at_end) {
  found_ = false;
  double after = piece.end();
  if (!anyBelow(piece.system(), at_end)) {
    after = suspected(piece, at_start, at_end);
    if (after == piece.end()) return after;
    piece.at(after, trial_);
    if (!anyBelow(piece.system(), trial_)) return piece.end();
    at_end = trial_;
  }
  found_ = true;
  scales_.resize(guards_.size());
  std::transform(guards_.begin(), guards_.end(), scales_.begin(),
                 [](double guard) { return guard < 0 ? -guard : 0; });
  setGuards(piece.system(), at_start, guards_);
  return locate(piece, piece.start(), after, at_end);
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

/// Regula falsi (Illinois), each trial a shorter step; by halves where that gains too little. The
/// sign of all guards decides, so that the bracket is certain whatever they do. guards_: at the
/// start.
double EventSearch::locate(const MotionPiece& piece, double before, double after,
                           SystemState& at_end) {
  const double precision = piece.system().event_precision * (piece.end() - piece.start());
  double low = lowestShare(), high = -1, last_width = after - before;
  int kept = 0;  // how often the same end stayed, and which
  for (int trial = 1; after - before > precision; ++trial) {
    const double width = after - before;
    const bool slow = trial % 3 == 0 && width > 0.5 * last_width;
    if (trial % 3 == 0) last_width = width;
    // off the ends, so that both of them move
    const double nudge = 0.5 * precision;
    double middle = before + width * std::clamp(low / (low - high), 0.0, 1.0);
    middle = std::clamp(middle, before + nudge, after - nudge);
    if (slow || !(middle > before && middle < after)) middle = before + 0.5 * width;
    if (!(middle > before && middle < after)) break;
    piece.at(middle, trial_);
    const double lowest_there = lowest(piece.system(), trial_);
    if (lowest_there < 0) {
      after = middle;
      high = lowest_there;
      kept = std::min(kept, 0) - 1;
      if (kept < -1) low *= 0.5;
      std::swap(at_end, trial_);
    } else {
      before = middle;
      low = lowest_there;
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
