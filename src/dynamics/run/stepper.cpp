#include "dynamics/run/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "dynamics/methods/accelerations.hpp"
#include "dynamics/rotation/free_motion.hpp"
#include "dynamics/run/contact_bound.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kLeastError = 1e-14;  // some ten roundings of a step that turns by a radian

std::string tooMuchForEvents(double work) {
  return "to end at its events, a step takes more than " + shortest(work) +
         " evaluations of the forces: what meets ever more of them, such as a body that drag "
         "brings into the centre of a force, cannot be followed; else take a shorter time_step";
}

}  // namespace

MethodChoice errorControlled() {
  MethodChoice choice;
  choice.method = &methodNamed("dop853");
  choice.by_estimates = true;
  return choice;
}

MethodChoice changedBy(const Beside& beside, const MethodChoice& choice) {
  MethodChoice changed = choice;
  changed.max_turn_share *= beside.turn_share;
  changed.bound_share *= beside.bound_share;
  changed.contact_bound *= beside.contact_share;
  if (changed.by_estimates) changed.substeps = std::max(changed.substeps, beside.least_substeps);
  return changed;
}

void Stepper::fallBackToErrorControl() {
  if (choice_.by_estimates || std::isinf(choice_.tried_until)) return;
  MethodChoice controlled = errorControlled();
  controlled.max_turn_share = choice_.max_turn_share;
  controlled.bound_share = choice_.bound_share;
  controlled.holds = choice_.holds;
  controlled.contact_bound = choice_.contact_bound;
  controlled.contact_work = choice_.contact_work;
  choice_ = controlled;
}

Stepper::Stepper(const MethodChoice& choice, const ErrorBound& tolerance, const System& system)
    : choice_(choice), tolerance_(tolerance) {
  if (choice_.contact_bound == 0) choice_.contact_bound = contactStepBound(tolerance.attitude);
  std::vector<Stiffness> stiffness(system.bodies.size());
  const auto consider = [&](const ForceLaw& law) {
    law.addStiffness(system.bodies, stiffness);
    rate_matters_ |= law.hasRate();
    speed_matters_ |= law.rateGrowsWithSpeed();
    has_kink_ |= law.hasKink();
  };
  for (const auto& law : system.laws) consider(*law);
  for (const auto& law : system.flows) consider(*law);
  for (const auto& stateful : system.stateful_laws) consider(*stateful.law);
  for (const Stiffness& of_body : stiffness)
    law_rate_ = std::max({law_rate_, std::sqrt(of_body.frequency_squared), of_body.decay});
}

void Stepper::restart(const System& system) {
  workspace_.wrenches_current = false;
  at_rest_ = false;
  const auto spins = [](const HeldWrench& held) { return !held.torqueFree(); };
  torque_matters_ =
      !system.coupled.empty() || std::any_of(system.held.begin(), system.held.end(), spins);
}

double Stepper::substepsNeeded(const System& system, double h, const SystemState& states) const {
  return std::ceil(h * fastestRate(system, h, states) /
                   (choice_.method->max_turn * choice_.max_turn_share));
}

/// [1/s] What turns, swings or decays fastest within a step of h.
double Stepper::fastestRate(const System& system, double h, const SystemState& states) const {
  double fastest = law_rate_;
  for (std::size_t i = 0; i < states.bodies.size(); ++i)
    fastest =
        std::max(fastest, angularVelocity(system.bodies[i]->inv_I, states.bodies[i].L_P).norm());
  if (rate_matters_) fastest = std::max(fastest, fastestOfLaws(system, h, states));
  return torque_matters_ ? std::max(fastest, rateBroughtAbout(system, h, states)) : fastest;
}

/// [1/s] At these states, and at the speeds that steady forces may bring about within h.
double Stepper::fastestOfLaws(const System& system, double h, const SystemState& states) const {
  std::vector<double> speeds;
  for (std::size_t i = 0; speed_matters_ && i < states.bodies.size(); ++i) {
    const Body& body = *system.bodies[i];
    const HeldWrench& held = system.held[i];
    const double push = body.mass * system.g_W.norm() + held.f_W.norm() + held.f_P.norm();
    speeds.push_back((states.bodies[i].p_W.norm() + h * push) / body.mass);
  }
  double fastest = 0;
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  for (const auto& law : system.laws) fastest = std::max(fastest, law->rate(at, speeds));
  for (const auto& law : system.flows) fastest = std::max(fastest, law->rate(at, speeds));
  // in contact the swings of several laws on one body add up
  const bool adds_up = system.has_contact && system.stateful_laws.size() > 1;
  std::vector<double> squares(adds_up ? states.bodies.size() : 0);  // of rates, by body
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    const double rate = law.rate(with_own, speeds);
    fastest = std::max(fastest, rate);
    if (!adds_up || rate == 0) return;
    for (std::size_t body : law.members()) squares[body] += rate * rate;
  });
  for (double square : squares) fastest = std::max(fastest, std::sqrt(square));
  return fastest;
}

/// [1/s] What torques may spin a body up to within h.
double Stepper::rateBroughtAbout(const System& system, double h, const SystemState& states) const {
  double fastest = 0;
  for (std::size_t i = 0; i < states.bodies.size(); ++i) {
    const BodyState& s = states.bodies[i];
    Wrench wrench = system.held[i].at(s);
    for (const PointWrench& applied : system.coupled)
      if (applied.body == i) addPointWrench(applied, states.bodies, wrench);
    const Vector3d L_dot_P = rotateBack(s.q_WP, wrench.tau_W) + wrench.tau_P;
    const Vector3d w_end_P =
        angularVelocity(system.bodies[i]->inv_I, Vector3d(s.L_P + h * L_dot_P));
    fastest = std::max(fastest, w_end_P.norm());
  }
  return fastest;
}

/// What the estimate of a step of h may reach, the motion changing at a rate: errors of attitude
/// add up over the steps to the horizon; errors of momenta, relative, grow by the angle turned by
/// then; those of a body at rest, by the time. At twice the step, in the run that estimates the
/// error, it is what leaves as many substeps: an estimate of order 8 grows 2⁹-fold over a step
/// twice as long.
StepBound Stepper::stepBound(double h, double rate) const {
  const double share = h / tolerance_.horizon, turned = std::max(1.0, rate * tolerance_.horizon);
  const double doubled = std::pow(choice_.max_turn_share, 8);
  const double allowed = tolerance_.attitude * share * choice_.bound_share * doubled;
  const StepBound follows;
  return {std::clamp(allowed / turned, kLeastError, follows.error),
          std::clamp(allowed * share / choice_.max_turn_share, kLeastIdle, follows.idle)};
}

/// [1/s²] Over the step, the rate of Claim kFeedsLeastAxis, of the body where it is greatest.
double Stepper::leastAxisGrowth(const System& system, const SystemState& states) const {
  double greatest = 0;
  for (std::size_t i = 0; i < states.bodies.size(); ++i) {
    const Body& body = *system.bodies[i];
    greatest =
        std::max(greatest, leastAxisExcess(tripleOf(body.inv_I), tripleOf(states.bodies[i].L_P)));
  }
  return greatest / 2;
}

/// The number of substeps in which to take a step of h.
int Stepper::divide(const System& system, double h, const SystemState& states) {
  const double turn = h * fastestRate(system, h, states);
  const double needed = std::ceil(turn / (choice_.method->max_turn * choice_.max_turn_share));
  const double substeps = std::max<double>(choice_.substeps, needed);
  constexpr double kMaxSubsteps = 1e5;
  if (!(substeps <= kMaxSubsteps)) failTooFast(system, h, states, "100000 substeps");
  if (choice_.by_estimates) workspace_.step_bound = stepBound(h / substeps, turn / h);
  if (choice_.method->claimsTo(kFeedsLeastAxis))
    magnification_ += h * h / substeps * leastAxisGrowth(system, states);
  if (needed > choice_.substeps) max_substeps_ = std::max(max_substeps_, static_cast<int>(needed));
  return static_cast<int>(substeps);
}

template <class Meter>
bool Stepper::advance(const System& system, double t, double h, SystemState& states, Meter& meter) {
  if (system.has_contact) return advanceInContact(system, t, h, states, meter);
  const int count = divide(system, h, states);
  if (system.has_events || heedsKinks()) return takeSubsteps(system, t, h, count, states, meter);
  for (int k = 0; k < count; ++k) {
    visit(system, t + k * (h / count), h / count, states, meter);
    takeStep(*choice_.method, system, h / count, states, workspace_);
  }
  return false;
}

/// [s] The longest substep, of those of length h, that does not come too near a kink of a law. A
/// third of the distance is followed as well as what is smooth, and a pass takes some fifty
/// substeps.
double Stepper::beforeKink(const System& system, double h, const SystemState& states) const {
  constexpr double kShare = 1.0 / 3, kRounding = 1e-15;
  constexpr double kOfTolerance = 1e-4;  // so that thousands of passes stay within it
  const double negligible = std::max(kOfTolerance * tolerance_.attitude, kRounding);
  const std::vector<BodyMotion> motions = motionsOf(system, states);
  double distance = std::numeric_limits<double>::infinity();
  const auto consider = [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    if (law.hasKink())
      distance = std::min(distance, law.distanceToKink(at, motions, h, negligible));
  };
  for (const auto& law : system.laws) consider(*law, {system.bodies, states.bodies});
  for (const auto& law : system.flows) consider(*law, {system.bodies, states.bodies});
  forStatefulLaws(system, states, consider);
  return kShare * distance;
}

/// [s] Of the next substep: what is left of the step in as few equal ones as are no longer than
/// asked for, or less beside a kink. There the bound of the estimates is as much less, so that they
/// add up to no more.
double Stepper::lengthBesideKinks(const System& system, double left, double substep,
                                  const StepBound& of_step, const SystemState& states) {
  constexpr double kRounding = 1e-9;
  const double even = left / std::max(1.0, std::ceil(left / substep - kRounding));
  const double allowed = beforeKink(system, substep, states);
  workspace_.step_bound = of_step;
  if (!(allowed < even)) return even;
  ++kink_substeps_;
  if (choice_.by_estimates) {
    const double share = allowed / substep;
    workspace_.step_bound.error = std::max(share * of_step.error, kLeastError);
    workspace_.step_bound.idle = std::max(share * of_step.idle, kLeastIdle);
  }
  return allowed;
}

/// Substeps that end at events, and are short beside kinks. Returns whether there were events.
template <class Meter>
bool Stepper::takeSubsteps(const System& system, double t, double h, int count, SystemState& states,
                           Meter& meter) {
  const double t_end = t + h, substep = h / count;
  const StepBound of_step = workspace_.step_bound;
  bool switched = false;
  const std::int64_t worked = work();
  constexpr int kMaxEvents = 100000;
  for (int taken = 0; t < t_end; ++taken) {
    if (taken > count + kMaxEvents) throw StepTooLong("a step holds more than 100000 events");
    if (system.has_events && static_cast<double>(work() - worked) > choice_.event_work)
      throw StepTooLong(tooMuchForEvents(choice_.event_work));
    const double left = t_end - t;
    // what is left by rounding goes into the last
    double length = left < 1.5 * substep && left > substep ? left : std::min(left, substep);
    if (heedsKinks()) length = lengthBesideKinks(system, left, substep, of_step, states);
    const double done = takeSubstep(system, t, length, states, meter);
    if (done < length) {
      meter.addEnergy(switchModes(system, states, contact_events_));
      workspace_.wrenches_current = false;
      switched = true;
    }
    t = done < length ? t + done : (length == left ? t_end : t + length);
  }
  return switched;
}

/// At most one substep of h, up to an event. Returns its length.
template <class Meter>
double Stepper::takeSubstep(const System& system, double t, double h, SystemState& states,
                            Meter& meter) {
  if (!system.has_events) {
    visit(system, t, h, states, meter);
    takeStep(*choice_.method, system, h, states, workspace_);
    return h;
  }
  const SystemState start = states;
  takeStep(*choice_.method, system, h, states, workspace_);
  scratch_.step_bound = workspace_.step_bound;
  // times from the start of the substep, so that rounding of the time does not limit the location
  const MotionPiece piece(system, *choice_.method, start, 0, h, scratch_);
  const std::int64_t looked = scratch_.evaluations;
  const double event = events_.firstEvent(piece, start, states);
  look_evaluations_ += scratch_.evaluations - looked;
  visit(system, t, event, start, meter);
  return event;
}

/// Shows the meter a substep that is about to be taken.
template <class Meter>
void Stepper::visit(const System& system, double t, double h, const SystemState& states,
                    Meter& meter) {
  if constexpr (!std::is_same_v<Meter, NoMeter>) {
    scratch_.step_bound = workspace_.step_bound;
    if (!choice_.method->claimsTo(kSolves))
      return meter(MotionPiece(system, *choice_.method, states, t, t + h, scratch_));
    const SolvedProblem problem{*system.bodies[0], system.held[0], system.g_W, {}};
    SolvedMotion motion(problem, t, states.bodies[0], t + h);
    followSolved(problem, t, t + h, t + h, motion,
                 [&](const SolvedMotion& solved, double from, double to) {
                   meter(MotionPiece(system, solved, states.laws, from, to));
                 });
  }
}

template bool Stepper::advance(const System&, double, double, SystemState&, NoMeter&);
template bool Stepper::advance(const System&, double, double, SystemState&, ExchangeMeter&);
template void Stepper::visit(const System&, double, double, const SystemState&, NoMeter&);
template void Stepper::visit(const System&, double, double, const SystemState&, ExchangeMeter&);

}  // namespace rigid_body_sim
