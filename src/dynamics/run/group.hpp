#pragma once

#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/run/choose_method.hpp"
#include "dynamics/run/exchange_meter.hpp"
#include "dynamics/run/solved_motion.hpp"
#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {

/// Bodies that act on one another, advanced together: solved where that is possible and asked for,
/// else stepped by a method.
class Group {
 public:
  /// Where the motion is to be solved, one body without laws or drag. The world must outlive the
  /// group and its copies.
  Group(const World& world, const CoupledBodies& bodies, unsigned needs,
        const MethodChoice& choice);

  /// What a method must accept to advance it (Need).
  unsigned needs() const { return needs_; }

  const MethodChoice& choice() const { return choice_; }
  const std::vector<std::size_t>& members() const { return members_; }

  /// [s] Up to, but without, this time nothing starts or ends, nothing is to be advanced and
  /// nothing can fail: putForeseen() tells the state. Minus infinity where there is no solution
  /// yet.
  double foreseenUntil(const std::vector<WrenchSchedule>& schedules) const;

  /// Writes the foreseen state at t < foreseenUntil() among those of all bodies.
  void putForeseen(double t, std::vector<BodyState>& bodies) const;

  /// To be called when the motion is no longer the one on which the choice was tried, because a
  /// message, say, changes it: a choice that was tried gives way to controlledChoice(). A wrench of
  /// the schedule that starts or ends after the trial's end does the same by itself, and so does
  /// the end of a trial that was cut short.
  void distrustTrial();

  /// Takes what starts and ends at time t into account; to be called after every change of the
  /// schedules or states from outside. schedules: one per body of the world.
  void restart(double t, std::vector<WrenchSchedule>& schedules);

  /// Advances the members from t, where theirs are among the states of all bodies, to t_end, split
  /// at every instant at which a wrench starts or ends: to states(). Throws StepTooLong.
  void advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
               const std::vector<BodyState>& bodies);

  /// The same, metered.
  void advance(double t, double t_end, std::vector<WrenchSchedule>& schedules,
               const std::vector<BodyState>& bodies, ExchangeMeter& meter);

  /// The members' states where they were last advanced to, in the order of members().
  const std::vector<BodyState>& states() const { return states_; }

  /// Writes them among those of all bodies.
  void putStates(std::vector<BodyState>& bodies) const;

  /// The parts in which a step of h must at least be taken for the method to follow what turns,
  /// swings or decays at the present states of all bodies.
  double partsNeeded(double h, const std::vector<BodyState>& bodies);

  /// The most parts that a step was taken in so far, because something turned, swung or decayed
  /// faster than the method follows in one; 1 when none was.
  int mostParts() const { return most_parts_; }

  /// Evaluations of all wrenches so far.
  std::int64_t evaluations() const { return workspace_.evaluations; }

 private:
  std::size_t localIndex(std::size_t body) const;
  void gatherWrenches(const std::vector<WrenchSchedule>& schedules);
  template <class Meter>
  void advanceMetered(double t, double t_end, std::vector<WrenchSchedule>& schedules,
                      const std::vector<BodyState>& bodies, Meter& meter);
  template <class Meter>
  void solve(double t, double t_end, double next_event, Meter& meter);
  StepBound stepBound(double h, double rate) const;
  double fastestRate(double h) const;
  double rateBroughtAbout(double h) const;
  template <class Meter>
  void stepInParts(double h, Meter& meter);

  std::vector<std::size_t> members_;
  unsigned needs_;
  MethodChoice choice_;
  System system_;
  Workspace workspace_;
  std::vector<BodyState> states_;
  std::optional<SolvedMotion> solved_;  // since the last event; empty before it is needed
  ErrorBound bound_;                    // of a solved motion; none: to rounding
  ErrorBound promise_;                  // what auto holds of a stepped one
  bool drag_counts_ = false;            // whether the method must follow the decay by drag
  bool speeds_up_ = false;              // whether that or torques bring rates about
  double law_rate_ = 0;                 // [1/s] the fastest that laws bring about at any state
  int most_parts_ = 1;
};

}  // namespace rigid_body_sim
