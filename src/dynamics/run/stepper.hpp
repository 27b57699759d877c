#pragma once

#include <cmath>
#include <string>

#include "dynamics/packs/packs.hpp"
#include "dynamics/run/event_search.hpp"
#include "dynamics/run/exchange_meter.hpp"
#include "dynamics/run/method_choice.hpp"
#include "dynamics/run/roam.hpp"

namespace rigid_body_sim {

/// Where nobody samples the motion; costs nothing.
struct NoMeter {
  void operator()(const MotionPiece&) {}
  void addEnergy(double) {}
  void addChange(const System&, const SystemState&, const SystemState&) {}
};

/// Advances a system by an integrator, over steps of any length: the one place where steps are
/// divided, so that the integrator can follow what turns, swings or decays fastest.
class Stepper {
 public:
  /// tolerance: what auto promises, for an integrator that is controlled by its estimates.
  Stepper(const MethodChoice& choice, const ErrorBound& tolerance, const System& system);

  const MethodChoice& choice() const { return choice_; }

  /// Largest number of substeps that a step was divided into so far beyond what was asked for,
  /// because something turned, swung or decayed too fast; 1 when none was.
  int maxSubsteps() const { return max_substeps_; }

  /// ln of the factor by which the integrator has magnified, so far, what a body turns about its
  /// axis of least inertia; see Claim kFeedsLeastAxis.
  double magnification() const { return magnification_; }

  /// Evaluations of all wrenches so far, those included by which events in contact were located.
  std::int64_t evaluations() const { return workspace_.evaluations; }

  /// Evaluations of all wrenches so far, those included by which any events were located.
  std::int64_t work() const { return evaluations() + look_evaluations_; }

  /// Steps so far within which a force jumped, or nearly so: see Workspace::rough_steps.
  std::int64_t roughSteps() const { return workspace_.rough_steps; }

  /// Substeps so far that were shorter than asked for, beside kinks of a law.
  std::int64_t kinkSubsteps() const { return kink_substeps_; }

  /// To be called when an input changes the motion that was tried: falls back to dop853 controlled
  /// by its own error estimates.
  void fallBackToErrorControl();

  /// To be called when what acts on the system has changed, or its state other than by advance().
  void restart(const System& system);

  /// Whether every step is taken as one, as long as the integrator can follow that.
  bool takesWholeSteps() const {
    return choice_.substeps == 1 && !choice_.by_estimates && std::isinf(choice_.tried_until);
  }

  /// Whether the wrenches at the present states are known from the step before.
  bool wrenchesCurrent() const { return workspace_.wrenches_current; }

  /// Takes over what steps elsewhere have counted; see Packs.
  void goOnFrom(const System& system, const SystemState& states, const Packs::Stepped& stepped);

  /// Substeps without which the integrator cannot follow a step of h from these states.
  double substepsNeeded(const System& system, double h, const SystemState& states) const;

  /// Advances the states from t by h, through the events of laws. Returns whether there were any;
  /// in a system with contact, whether it stopped at one by which a law begins or ceases to act.
  /// Throws StepTooLong.
  template <class Meter>
  bool advance(const System& system, double t, double h, SystemState& states, Meter& meter);

  /// Puts bodies in contact to rest where it is certain that they have come to it; see RestSearch.
  /// They stay there, at no cost, until restart(). Returns whether they rest.
  template <class Meter>
  bool settle(const System& system, SystemState& states, Meter& meter);

  bool isAtRest() const { return at_rest_; }

  /// As they were, in a state that is taken up.
  void restAsBefore() { at_rest_ = true; }

  /// Makes advance() stop, as at an event, where a body of a system with contact has nearly used
  /// up how far it is taken to go; body by body. Empty: none does.
  void setRoams(std::vector<Roam> roams) { roams_ = std::move(roams); }

  /// [s] Where the last advance() stopped.
  double stoppedAt() const { return stopped_at_; }

  /// Moves the touches and releases since the last call to the end of a list.
  void moveContactEvents(std::vector<ContactEvent>& events);

 private:
  double fastestRate(const System& system, double h, const SystemState& states) const;
  double fastestOfLaws(const System& system, double h, const SystemState& states) const;
  [[noreturn]] void failTooFast(const System& system, double h, const SystemState& states,
                                const std::string& limit) const;
  double rateBroughtAbout(const System& system, double h, const SystemState& states) const;
  /// The one integrator whose order a kink takes away altogether.
  bool heedsKinks() const { return has_kink_ && choice_.method->claimsTo(kEstimatesError); }
  double beforeKink(const System& system, double h, const SystemState& states) const;
  double lengthBesideKinks(const System& system, double left, double substep,
                           const StepBound& of_step, const SystemState& states);
  StepBound stepBound(double h, double rate) const;
  double leastAxisGrowth(const System& system, const SystemState& states) const;
  int divide(const System& system, double h, const SystemState& states);
  template <class Meter>
  bool takeSubsteps(const System& system, double t, double h, int count, SystemState& states,
                    Meter& meter);
  template <class Meter>
  double takeSubstep(const System& system, double t, double h, SystemState& states, Meter& meter);
  template <class Meter>
  bool advanceInContact(const System& system, double t, double h, SystemState& states,
                        Meter& meter);
  StepBound contactBound() const;
  double stableStep(const System& system, double h, const SystemState& states) const;
  double shareToBegin() const;
  double smoothStep(const System& system, const SystemState& states) const;
  double takeEstimatedStep(const System& system, double h, double stable, SystemState& states,
                           double& next);
  bool isBeyond(const SystemState& states) const;
  bool switchContacts(const System& system, double t, SystemState& states, double& energy);
  template <class Meter>
  void visit(const System& system, double t, double h, const SystemState& states, Meter& meter);

  MethodChoice choice_;
  ErrorBound tolerance_;
  Workspace workspace_;
  Workspace scratch_;            // for looking into a substep
  EventSearch events_;           // of the laws
  double law_rate_ = 0;          // [1/s] the fastest that laws bring about at any state
  bool rate_matters_ = false;    // whether a law has a rate
  bool speed_matters_ = false;   // whether a law's rate grows with speed
  bool torque_matters_ = false;  // whether torques other than the laws' may spin a body up
  bool has_kink_ = false;        // whether a law has one
  int max_substeps_ = 1;
  std::int64_t kink_substeps_ = 0;
  std::int64_t look_evaluations_ = 0;  // by which events out of contact were located
  double magnification_ = 0;
  double stopped_at_ = 0;
  bool at_rest_ = false;
  std::vector<Roam> roams_;
  std::vector<ContactEvent> contact_events_;
};

}  // namespace rigid_body_sim
