#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/grouping.hpp"
#include "dynamics/run/run_contacts.hpp"
#include "dynamics/run/run_motors.hpp"
#include "dynamics/run/step_record.hpp"

namespace rigid_body_sim {

/// Advances a world step by step, and takes inputs over between steps. Knows nothing of who
/// watches.
class Run {
 public:
  /// Goes on from a state, at a step of the world. Throws std::invalid_argument for an integrator
  /// that is unknown or does not support what acts.
  Run(const std::shared_ptr<const World>& world, const std::shared_ptr<const State>& start);

  /// The same run at twice the step, from a step of even count on, to compare with.
  Run atTwiceTheStep() const;

  /// The same run, in which steps in contact may err by more and what flies is solved to rounding,
  /// to compare with.
  Run atLooserBounds() const;

  /// The same run, in which steps that are divided by error estimates may err by less and are at
  /// most half as long, to compare with.
  Run atTighterBounds() const;

  /// Begins anew at the start, with steps in contact bounded so.
  void boundContact(const ContactTrial& trial);

  /// Lets a time step take no more work in contact than this; see maxContactWork.
  void limitContactWork(double work);

  /// That trial; after load(), the bound of the state that was loaded.
  ContactTrial contactTrial() const;

  const RunState& now() const { return now_; }

  /// Throws std::invalid_argument, naming the body, where the integrator does not support a need.
  void requireSupport(unsigned needs, const std::string& body) const {
    grouping_.planner().requireSupport(needs, body);
  }

  /// One time step. Throws SimulationDiverged; then nothing has happened, to any body.
  void step() { advance(nullptr); }

  /// So many steps. Throws SimulationDiverged after those that could be taken.
  void step(std::int64_t count, std::vector<BodyState>* states = nullptr);

  /// Goes on to a time t within the step that comes next; step() ends it. Not for a run of which
  /// events or inputs count.
  void stepPart(double t);

  /// The same as step(), every piece of motion shown to the meter.
  void step(ExchangeMeter& meter) { advance(&meter); }

  BodyState body(std::size_t body) const {
    if (now_.packs.holds(body)) return now_.packs.state(body);
    if (!moves(now_.world->bodies[body])) return now_.start->bodies[body];
    return now_.groups.at(body, now_.time);
  }
  /// backward: from the last body to the first; the same states.
  void readBodies(std::vector<BodyState>& states, bool backward = false) const;
  State state() const;

  /// The state at a time between now and the next step; the run goes on as if never asked.
  State sample(double t) const;

  /// How these bodies move and accelerate then.
  std::vector<BodyMotion> motions(const std::vector<std::size_t>& bodies, double t) const;

  /// Of the last step, in order; of the start, before the first.
  const std::vector<ContactEvent>& contactEvents() const { return contacts_.eventsOf(now_.steps); }

  /// Puts a wrench into a slot now; see WrenchSchedule::put.
  void put(const std::string& slot, const PointWrench& wrench);

  /// Ends wrenches of a body: of a slot, empty: of every slot. Returns whether there were any.
  bool clear(std::size_t body, const std::string& slot);

  void setState(std::size_t body, const BodyState& state);

  /// Commands an actuator, from its start on or from now.
  void command(const ActuatorCommand& command);

  /// Sets the velocity of the medium; bodies that it does not touch keep their bits.
  void setWind(const Vector3d& velocity_W);

  /// See Simulation::setMassProperties. Throws std::invalid_argument, and leaves all as it was, for
  /// properties that break a rule.
  void setMassProperties(std::size_t body, const MassProperties& properties_B);

  /// See Simulation::setPresent. state: with which the body comes in; none: it leaves.
  void setPresent(std::size_t body, const std::optional<BodyState>& state);

  /// Back to the start; see ResetInput.
  void reset(bool restart_time);

  /// On from a state; see Simulation::load. Throws std::invalid_argument, and leaves all as it was,
  /// where its plans are not those of a run of this world.
  void load(const State& state);

 private:
  void enter(const std::vector<BodyChange>& changes);
  void place(const State& start, bool scheduled);
  void goOnAs(Run& changed, const State& state);
  Run beside(const Beside& other) const;
  void advance(ExchangeMeter* meter);
  void advanceGroups(double t_end, ExchangeMeter* meter);
  std::vector<std::size_t> acceptGroups(double t_end);
  void accept(double t_end);
  void acceptBegun(double t_end);
  void endStepAt(double t_end);
  void takeBack();
  void preparePacks(double t_end, bool metered);
  std::int64_t packedSteps(std::int64_t at_most) const;
  void restartGroup(std::size_t body);
  Run goneOnTo(double t) const;
  State present() const;
  void readGroups(std::size_t first, std::size_t end, bool backward,
                  std::vector<BodyState>& states) const;
  std::vector<BodySchedule> scheduleEntries() const;

  ContactTrial contact_trial_;
  RunState now_;
  Grouping grouping_;
  MethodPlanner::Trials start_trials_;  // while the world is not that of the start
  RunMotors motors_;
  RunContacts contacts_;
  StepRecord step_;
  /// Every second time states are read after steps: those read last are still in the cache.
  bool reads_backward_ = false;
};

}  // namespace rigid_body_sim
