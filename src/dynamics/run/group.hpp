#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/packs/flight_kernels.hpp"
#include "dynamics/packs/packs.hpp"
#include "dynamics/run/coupling.hpp"
#include "dynamics/run/stepper.hpp"
#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {

/// Bodies that act on one another, advanced together: solved where that is possible and asked for,
/// else stepped by an integrator. Its motion is a sequence of pieces (MotionPiece).
///
/// A step is a transaction: advance() leaves the present alone until accept(); rollBack() forgets
/// it.
class Group {
 public:
  /// start: the states of the members at t; law_states: State::laws. The world must outlive the
  /// group and its copies.
  Group(const World& world, const LawTable& laws, const CoupledBodies& bodies,
        const MethodChoice& choice, double t, std::vector<BodyState> start,
        const std::vector<double>& law_states, const std::vector<WrenchSchedule>& schedules);

  /// Anchors a solved motion where it was anchored before; then the same bits follow.
  void anchor(const MotionAnchor& anchor);

  /// Anchors a solved motion at the present.
  void anchorHere(const std::vector<WrenchSchedule>& schedules);

  const std::vector<std::size_t>& members() const { return bodies_.members; }
  const CoupledBodies& bodies() const { return bodies_; }
  double time() const { return t_; }  ///< [s] of present()
  const MethodChoice& choice() const { return stepper_ ? stepper_->choice() : solved_choice_; }
  int maxSubsteps() const { return stepper_ ? stepper_->maxSubsteps() : 1; }
  double magnification() const { return stepper_ ? stepper_->magnification() : 0; }
  std::int64_t evaluations() const { return stepper_ ? stepper_->evaluations() : 0; }
  std::int64_t roughSteps() const { return stepper_ ? stepper_->roughSteps() : 0; }
  std::int64_t kinkSubsteps() const { return stepper_ ? stepper_->kinkSubsteps() : 0; }
  double substepsNeeded(double h) const { return stepper_->substepsNeeded(system_, h, present_); }

  /// [s] First time at which the group must be advanced; −∞ if its motion is not solved yet.
  double knownUntil(const std::vector<WrenchSchedule>& schedules) const;

  /// The state of member k at a time t from the present to knownUntil().
  BodyState at(double t, std::size_t k) const {
    return solved_ && t != t_ ? solved_->at(t) : present_.bodies[k];
  }

  /// The same of a free flight, which a batch may write later; returns false where it is none.
  bool readFlight(double t, FlightBatch& batch, BodyState& state) const {
    const FreeFlight* flight = solved_ && t != t_ ? solved_->asFlight() : nullptr;
    if (flight) batch.read(*flight, t - solved_->anchoredAt(), state);
    return flight != nullptr;
  }

  /// Asks the memory for what readFlight reads, a while before.
  void announceRead() const {
    constexpr std::size_t kLine = 64;
    const auto* first = reinterpret_cast<const char*>(&t_);
    const auto* end = reinterpret_cast<const char*>(&solved_ + 1);
    for (const char* line = first; line < end; line += kLine) __builtin_prefetch(line);
  }

  /// How its members move and accelerate at a time t from the present to knownUntil(), in the order
  /// of members().
  std::vector<BodyMotion> motions(double t) const;

  /// Writes the laws' own states at present among those of all laws.
  void putLawStates(const LawTable& table, std::vector<double>& law_states) const;

  /// Where a solved motion is anchored; else the present.
  MotionAnchor anchorOf(std::size_t k) const;

  void fallBackToErrorControl();

  /// Whether an advance() may stop before its end, at the instant at which a contact begins or
  /// ceases to act: groups are to be formed anew there.
  bool mayStop() const { return system_.has_contact && !isAtRest(); }

  /// [s] Where the last advance() to t_end has led to.
  double advancedTo(double t_end) const {
    return switched_ && system_.has_contact ? stepper_->stoppedAt() : t_end;
  }

  /// Puts its bodies to rest, at the present, where it is certain that they have come to it. They
  /// stay where they are until an event on one of them, restart() or setState().
  void settle();
  void settle(ExchangeMeter& meter);
  bool isAtRest() const { return stepper_ && stepper_->isAtRest(); }
  void restAsBefore() { stepper_->restAsBefore(); }

  /// [s] Up to when it stays at rest.
  double restsUntil(const std::vector<WrenchSchedule>& schedules) const {
    return isAtRest() ? nextEvent(schedules) : -std::numeric_limits<double>::infinity();
  }

  /// How it moves, where that is the same from step to step; see Packs.
  std::optional<SteadyMotion> steadyMotion() const;

  /// Goes on at time t, the present, from where packs have led it.
  void goOnFrom(double t, const Packs::Stepped& stepped);

  /// Whether its motion is known beforehand: solved, or at rest.
  bool isSolvedAhead() const { return !choice().method || isAtRest(); }

  /// See Stepper::setRoams; member by member.
  void setRoams(std::vector<Roam> roams) { stepper_->setRoams(std::move(roams)); }

  /// Whether a law belongs to it, acting or not; an index of the world.
  bool follows(std::size_t law) const;

  /// Moves the touches and releases since the last call, by the indices of the world, to the end of
  /// a list.
  void moveContactEvents(std::vector<ContactEvent>& events);

  /// What is known of the motion of its bodies while it is solved, of one, or at rest; else
  /// nothing.
  std::optional<MotionBound> motionBound(const std::vector<WrenchSchedule>& schedules) const;

  /// Takes over at time t, the present, what the schedules say from there on.
  void restart(double t, const std::vector<WrenchSchedule>& schedules);

  /// Sets the present state of member k.
  void setState(std::size_t k, const BodyState& state);

  /// Advances from t, the present, to t_end, split at every instant at which a wrench starts or
  /// ends and at the events of laws. Throws StepTooLong.
  void advance(double t, double t_end, std::vector<WrenchSchedule>& schedules);
  void advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
               ExchangeMeter& meter);

  /// Where the last accept() has led to, in the order of members(); of a solved motion it may be
  /// older than the present.
  const SystemState& present() const { return present_; }

  /// Where the last advance() has led to, in the order of members().
  const SystemState& advanced() const { return next_; }

  /// Whether a law switched its mode in the last advance(): groups may have to be formed anew.
  bool switchedModes() const { return switched_; }

  void accept(double t_end);

  /// schedules: taken back already.
  void rollBack(const std::vector<WrenchSchedule>& schedules);

 private:
  void addLaws(const World& world, const std::vector<std::size_t>& laws, const LawTable& table,
               const std::vector<double>& law_states);
  void addPivots(const World& world);
  std::size_t localIndex(std::size_t body) const;
  void addActuators(const std::vector<WrenchSchedule>& schedules);
  void gatherActuators(const std::vector<WrenchSchedule>& schedules);
  void gatherMedium();
  void setClocks(double t, std::vector<double>& laws) const;
  void gatherWrenches(const std::vector<WrenchSchedule>& schedules);
  double nextEvent(const std::vector<WrenchSchedule>& schedules) const;
  SolvedProblem problem() const {
    return {*system_.bodies[0], system_.held[0], system_.g_W, bound_, solved_choice_.read_once};
  }
  template <class Meter>
  void advanceMetered(double t, double t_end, std::vector<WrenchSchedule>& schedules, Meter& meter);
  template <class Meter>
  void solve(double t, double t_end, double next_event, Meter& meter);
  void keepMotion();

  CoupledBodies bodies_;
  std::vector<std::size_t> stateful_laws_;  // indices in the world, in the order of the system's
  System system_;
  SystemState present_;  // of a solved motion: at its anchor, or later
  SystemState next_;
  std::optional<Stepper> stepper_;      // none where the motion is solved
  MethodChoice solved_choice_;          // likewise
  double t_;                            // [s] of present_
  std::optional<SolvedMotion> solved_;  // since the last event; empty before it is needed
  /// The motion as a step found it, once it has changed that: its anchor, or none.
  struct Kept {
    std::optional<MotionAnchor> anchor;
    double next_event;
  };
  std::optional<Kept> kept_;
  double anchored_until_ = 0;  // [s] the horizon of the present anchor
  ErrorBound bound_;           // of a solved motion; none: to rounding
  bool switched_ = false;
};

}  // namespace rigid_body_sim
