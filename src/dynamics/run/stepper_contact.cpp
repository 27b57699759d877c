#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "dynamics/rest/rest.hpp"
#include "dynamics/run/stepper.hpp"

/// Steps of systems with contact: between many events, as long as the integrator's estimates allow.
namespace rigid_body_sim {
namespace {

constexpr double kMaxGrowth = 2;   // of a step, beside the one before
constexpr double kStableTurn = 5;  // [rad] of dop853, which damps up to 5.9: StabilityOfDop853

/// Which laws act.
std::vector<bool> actingLaws(const System& system, const SystemState& states) {
  std::vector<bool> acting;
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    acting.push_back(law.acts(at.own));
  });
  return acting;
}

}  // namespace

void Stepper::moveContactEvents(std::vector<ContactEvent>& events) {
  events.insert(events.end(), contact_events_.begin(), contact_events_.end());
  contact_events_.clear();
}

StepBound Stepper::contactBound() const {
  // least share: of steps of bounces, true errors are 0.1 to 0.7 times that power, the greater the
  // longer the step
  constexpr double kIdleShare = 1e-2, kLeastShare = 0.25;
  return {choice_.contact_bound, std::max(kIdleShare * choice_.contact_bound, kLeastIdle),
          kLeastShare};
}

/// [s] Within which the integrator is stable and its estimate can be believed, where forces are
/// smooth: what swings or decays within it by kStableTurn is damped, and its estimate is beyond its
/// error.
double Stepper::stableStep(const System& system, double h, const SystemState& states) const {
  return kStableTurn / std::max(fastestRate(system, h, states), 1e-300);
}

/// Of stableStep: with which to begin, where no step before tells. As a rule steps that are longer
/// err by more than the bound.
double Stepper::shareToBegin() const {
  constexpr double kTurn = 8, kOrder = 8;
  return std::min(1.0, kTurn * std::pow(workspace_.step_bound.error, 1 / kOrder) / kStableTurn);
}

/// [s] Within which forces are smooth enough for that.
double Stepper::smoothStep(const System& system, const SystemState& states) const {
  double longest = std::numeric_limits<double>::infinity();
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    if (law.acts(at.own))
      longest = std::min(longest, law.longestStep(at, workspace_.step_bound.error));
  });
  return longest;
}

/// At most a step of h. Returns its length, and in `next` the length that the estimate suggests for
/// the next one. stable [s]: an error of momentum does not count that moves a body by less than
/// rounding within so long: beside a touch or a release steps are far shorter, and what they do to
/// the momentum lasts.
double Stepper::takeEstimatedStep(const System& system, double h, double stable,
                                  SystemState& states, double& next) {
  constexpr double kRounding = 1e-12, kSafety = 0.9, kOrder = 8;
  const StepBound of_step = workspace_.step_bound;
  const double bound = of_step.error;
  const SystemState start = states;
  double last_error = std::numeric_limits<double>::infinity();
  constexpr int kMaxTries = 200;
  for (int tries = 0; tries < kMaxTries; ++tries) {
    workspace_.step_bound.idle = of_step.idle * std::min(1.0, h / stable);
    choice_.method->step(system, h, states, workspace_);
    workspace_.step_bound = of_step;
    const double error = workspace_.error;
    // shorter steps no longer help: rounding dominates
    const bool stuck = error <= kRounding && error > 0.5 * last_error;
    const double factor = kSafety * std::pow(bound / std::max(error, 1e-3 * bound), 1 / kOrder);
    if (error <= bound || stuck) {
      // after one that was too long, the next is no longer
      next = h * (stuck ? 1 : std::clamp(factor, 0.2, tries > 0 ? 1.0 : kMaxGrowth));
      return h;
    }
    states = start;
    last_error = error;
    h *= std::isfinite(error) ? std::clamp(factor, 0.1, 0.8) : 0.1;
  }
  throw StepTooLong(std::string(choice_.method->name) +
                    " cannot follow a contact, however short its substeps; a softer contact is "
                    "needed");
}

bool Stepper::isBeyond(const SystemState& states) const {
  for (std::size_t k = 0; k < roams_.size(); ++k)
    if (roams_[k].isNearlyUsedUp(states.bodies[k])) return true;
  return false;
}

/// Returns whether a law has begun or ceased to act.
bool Stepper::switchContacts(const System& system, double t, SystemState& states, double& energy) {
  const std::vector<bool> acted = actingLaws(system, states);
  const std::size_t first = contact_events_.size();
  energy = switchModes(system, states, contact_events_);
  for (std::size_t i = first; i < contact_events_.size(); ++i) contact_events_[i].t = t;
  workspace_.wrenches_current = false;
  return acted != actingLaws(system, states);
}

template <class Meter>
bool Stepper::advanceInContact(const System& system, double t, double h, SystemState& states,
                               Meter& meter) {
  if (at_rest_) return false;
  workspace_.step_bound = contactBound();
  const std::int64_t evaluated = evaluations();
  const auto bodies = static_cast<double>(system.bodies.size());
  double done = 0, next = -1;
  bool goes_on = false;
  constexpr int kMaxSubsteps = 1000000;
  // what laws bring about at any state lasts over the whole step: that is known beforehand
  if (!(h * law_rate_ <= kMaxSubsteps * choice_.method->max_turn))
    failTooFast(system, h, states, "1e6 substeps in contact");
  while (done < h) {
    if (static_cast<double>(evaluations() - evaluated) * bodies > choice_.contact_work)
      throw StepTooLong(tooMuchContact(choice_.contact_work));
    const double left = h - done;
    const double stable = stableStep(system, h, states);
    if (next < 0) next = shareToBegin() * stable;
    double step = std::min({left, next, stable, smoothStep(system, states)});
    if (step < left && step > 0.5 * left) step = 0.5 * left;  // no sliver at the end
    const SystemState start = states;
    step = takeEstimatedStep(system, step, std::min(h, stable), states, next);
    scratch_.step_bound = workspace_.step_bound;
    const MotionPiece piece(system, *choice_.method, start, 0, step, scratch_);
    const CubicBetween cubic(start, states, workspace_, step);
    const std::int64_t before = scratch_.evaluations;
    const double length = events_.firstEvent(piece, start, states, &cubic, goes_on);
    workspace_.evaluations += scratch_.evaluations - before;
    goes_on = !events_.found();
    visit(system, t + done, length, start, meter);
    done = length == left ? h : done + length;
    bool stops = done < h && isBeyond(states);
    if (events_.found()) {
      double energy = 0;
      stops |= switchContacts(system, t + done, states, energy);
      meter.addEnergy(energy);
    }
    if (!stops) continue;
    stopped_at_ = done == h ? t + h : std::min(t + done, t + h);
    return true;
  }
  return false;
}

template <class Meter>
bool Stepper::settle(const System& system, SystemState& states, Meter& meter) {
  if (at_rest_) return true;
  const RestSearch search(tolerance_.attitude, tolerance_.horizon);
  const double fastest = fastestRate(system, 0, states);
  if (std::optional<SystemState> rest = search.rest(system, states, fastest)) {
    meter.addChange(system, states, *rest);
    states = std::move(*rest);
    at_rest_ = true;
  }
  return at_rest_;
}

template bool Stepper::settle(const System&, SystemState&, NoMeter&);
template bool Stepper::settle(const System&, SystemState&, ExchangeMeter&);
template bool Stepper::advanceInContact(const System&, double, double, SystemState&, NoMeter&);
template bool Stepper::advanceInContact(const System&, double, double, SystemState&,
                                        ExchangeMeter&);

}  // namespace rigid_body_sim
