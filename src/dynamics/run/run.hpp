#pragma once

#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/law_watches.hpp"
#include "dynamics/run/method_planner.hpp"
#include "dynamics/run/step_record.hpp"

namespace rigid_body_sim {

/// Advances a world step by step: schedules of wrenches, groups of bodies, transactions. Knows
/// nothing of who watches.
class Run {
 public:
  /// Goes on from a state, at a step of the world. Throws std::invalid_argument for an integrator
  /// that is unknown or does not support what acts.
  Run(std::shared_ptr<const World> world, std::shared_ptr<const State> start);

  /// The same run at twice the step, from a step of even count on, to compare with.
  Run atTwiceTheStep() const;

  const World& world() const { return *world_; }
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }

  /// One time step. Throws SimulationDiverged; then nothing has happened, to any body.
  void step();

  /// The same, every piece of motion shown to the meter.
  void step(ExchangeMeter& meter);

  BodyState body(std::size_t body) const {
    if (world_->bodies[body].fixed) return start_->bodies[body];
    return groups_.at(body, time_);
  }
  State state() const;

  /// The state at a time between now and the next step; the run goes on as if never asked.
  State sample(double t) const;

  /// How these bodies move and accelerate then.
  std::vector<BodyMotion> motions(const std::vector<std::size_t>& bodies, double t) const;

  const std::vector<WrenchSchedule>& schedules() const { return schedules_; }
  const Groups& groups() const { return groups_; }
  const MethodPlanner& planner() const { return planner_; }

  /// Whether any law of the world is a contact.
  bool hasContacts() const { return !laws_.contacts().empty(); }

  /// Of the last step, in order; of the start, before the first.
  const std::vector<ContactEvent>& contactEvents() const;

  /// Puts a wrench into a slot now; see WrenchSchedule::put.
  void put(const std::string& slot, const PointWrench& wrench);

  /// Ends wrenches of a body: of a slot, empty: of every slot. Returns whether there were any.
  bool clear(std::size_t body, const std::string& slot);

  void setState(std::size_t body, const BodyState& state);

  /// Commands an actuator, from its start on or from now.
  void command(const ActuatorCommand& command);

  /// Back to the start; see ResetInput.
  void reset(bool restart_time);

 private:
  void place(const State& start, bool scheduled);
  void takeActuators();
  void placeActuators(const State& start, bool scheduled);
  std::vector<std::vector<ActuatorState>> actuatorStates(
      const std::vector<WrenchSchedule>& schedules) const;
  void formGroups(const State& start, bool scheduled);
  void findNextLink();
  std::vector<std::size_t> linkedFrom(double t) const;
  template <class... Meter>
  void stepMetered(Meter&... meter);
  template <class... Meter>
  void advanceLinking(double t_end, Meter&... meter);
  template <class... Meter>
  void settle(double t_end, Meter&... meter);
  void findCandidates(double t_end);
  void beginLinking(double t_end);
  template <class... Meter>
  void advanceToEvent(const LawWatches::Event& event, double t_end, Meter&... meter);
  template <class... Meter>
  bool advanceTo(double t, double t_end, const std::vector<std::size_t>& bodies, Meter&... meter);
  template <class... Meter>
  bool advanceContact(double limit, double t_end, Meter&... meter);
  template <class... Meter>
  double advanceGroup(std::size_t g, double t, double t_end, Meter&... meter);
  template <class... Meter>
  void advance(Group& group, double t_end, std::vector<WrenchSchedule>& schedules,
               Meter&... meter) const;
  void accept(double t_end);
  void takeBack();
  void regroup(const std::vector<std::size_t>& bodies, double t, bool anew = false);
  void restartGroup(std::size_t body);
  void disturb(std::size_t body);
  void startContacts(const std::vector<std::size_t>& laws, const std::vector<BodyState>& bodies);
  void restartContacts(std::size_t body);
  State sampleLinking(double t) const;
  bool linksUntil(double t) const { return next_link_ <= t || watches_.quietUntil() <= t; }
  Run goneOnTo(double t) const;
  BodyMotion motionOfFixed(std::size_t body) const;
  std::vector<BodyMotion> motionsOfGroup(std::size_t group, double t,
                                         std::vector<WrenchSchedule>& schedules) const;
  BodyState bodyAt(std::size_t body, double t) const;
  std::vector<double> lawStates() const;
  WatchedRun watched() const;

  std::shared_ptr<const World> world_;
  std::shared_ptr<const State> start_;
  bool commanded_ = false;  // whether that is a state in which commands were taken already
  LawTable laws_;
  MethodPlanner planner_;
  LawWatches watches_;
  std::int64_t steps_ = 0;
  double time_ = 0;
  std::vector<double> law_states_;         // State::laws; of laws that act, as old as their group
  std::vector<WrenchSchedule> schedules_;  // one per body
  Groups groups_;
  double next_link_ = 0;  // [s] when wrenches link or part bodies
  std::vector<ContactEvent> contact_events_;
  std::int64_t contact_events_step_ = 0;  // the step at the end of which they hold
  StepRecord step_;
};

}  // namespace rigid_body_sim
