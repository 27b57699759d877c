#include "dynamics/run/event_search.hpp"

#include <algorithm>
#include <cmath>

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

double EventSearch::firstEvent(const MotionPiece& piece, const SystemState& at_start,
                               SystemState& at_end) {
  double after = piece.end();
  if (!anyBelow(piece.system(), at_end)) {
    after = suspected(piece, at_start, at_end);
    if (after == piece.end()) return after;
    piece.at(after, trial_);
    if (!anyBelow(piece.system(), trial_)) return piece.end();
    at_end = trial_;
  }
  // bisection by the sign of all guards: certain, whatever they do; some 50 shorter steps an event
  double before = piece.start();
  while (true) {
    const double middle = before + 0.5 * (after - before);
    if (!(middle > before && middle < after)) return after;
    piece.at(middle, trial_);
    if (anyBelow(piece.system(), trial_)) {
      after = middle;
      std::swap(at_end, trial_);
    } else {
      before = middle;
    }
  }
}

double switchModes(const System& system, SystemState& states) {
  constexpr int kMaxSwitches = 100;
  double energy = 0;
  std::vector<double> guards;
  for (const System::StatefulLaw& stateful : system.stateful_laws) {
    const ForceLaw& law = *stateful.law;
    double* own = states.laws.data() + stateful.first;
    const ForceLaw::Bodies at{system.bodies, states.bodies, own};
    guards.resize(law.guardCount());
    for (int switches = 0; !guards.empty(); ++switches) {
      law.setGuards(at, guards.data());
      const auto below =
          std::find_if(guards.begin(), guards.end(), [](double guard) { return guard < 0; });
      if (below == guards.end()) break;
      if (switches == kMaxSwitches)
        throw StepTooLong(std::string("the modes of a ") + law.name() + " switch without end");
      energy -= potentialOf(law, at);
      law.switchMode(static_cast<std::size_t>(below - guards.begin()), at, own);
      energy += potentialOf(law, at);
    }
  }
  return energy;
}

}  // namespace rigid_body_sim
