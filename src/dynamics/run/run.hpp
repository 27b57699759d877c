#pragma once

#include <limits>
#include <memory>
#include <set>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/group.hpp"
#include "dynamics/run/law_watch.hpp"
#include "dynamics/run/method_planner.hpp"

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
    return groups_[group_of_[body]].at(time_, member_of_[body]);
  }
  State state() const;

  /// The state at a time between now and the next step; the run goes on as if never asked.
  State sample(double t) const;

  const std::vector<WrenchSchedule>& schedules() const { return schedules_; }
  const std::vector<Group>& groups() const { return groups_; }
  const MethodPlanner& planner() const { return planner_; }
  int maxSubsteps() const;
  std::int64_t evaluations() const;

  /// Whether any law of the world is a contact.
  bool hasContacts() const { return !laws_.contacts().empty(); }

  /// Of the last step, in order; of the start, before the first.
  const std::vector<ContactEvent>& contactEvents() const;

  /// Puts a wrench into a slot now; see WrenchSchedule::put.
  void put(const std::string& slot, const PointWrench& wrench);

  /// Ends wrenches of a body: of a slot, empty: of every slot. Returns whether there were any.
  bool clear(std::size_t body, const std::string& slot);

  void setState(std::size_t body, const BodyState& state);

  /// Back to the start; see ResetInput.
  void reset(bool restart_time);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kNotKnown = -kNever;

  /// What a step has begun, and takes back where it fails.
  struct Step {
    std::vector<std::size_t> advanced;   // groups
    std::vector<std::size_t> scheduled;  // bodies with an event within it
    std::vector<Group> regrouped;    // groups as it found them, that were linked or parted in it
    std::vector<double> law_states;  // as it found them, where there were such
  };

  void place(const State& start, bool scheduled);
  void formGroups(const State& start, bool scheduled);
  void addGroup(Group group);
  void removeGroups(const std::vector<std::size_t>& bodies);
  void findNextLink();
  void watchLaws();
  void findNextWatch();
  void wakeWatches(const std::vector<std::size_t>& bodies);
  void startContacts(const std::vector<std::size_t>& laws, const std::vector<BodyState>& bodies);
  void restartContacts(std::size_t body);
  bool isWatched(const LawWatch& watch) const;
  struct WatchedEvent {
    LawWatch* watch;
    double t;            // [s]
    bool links = false;  // its bodies, and does not act yet
  };
  std::optional<WatchedEvent> firstWatchedEvent(double t_end);
  bool isSolved(const LawWatch& watch) const;
  bool isNear(const LawWatch& watch, double t, double t_end) const;
  void partFromNear(double t_end);
  template <class... Meter>
  void stepMetered(Meter&... meter);
  template <class... Meter>
  void advanceLinking(double t_end, Meter&... meter);
  template <class... Meter>
  void advanceTo(double t, double t_end, const std::vector<std::size_t>& bodies, Meter&... meter);
  template <class... Meter>
  bool advanceContact(double limit, double t_end, Meter&... meter);
  template <class... Meter>
  double advanceGroup(std::size_t g, double t, double t_end, Meter&... meter);
  template <class... Meter>
  void advance(Group& group, double t_end, std::vector<WrenchSchedule>& schedules,
               Meter&... meter) const;
  void begin(std::size_t group, double t_end);
  void takeBack();
  void takeBackGroups();
  void accept(double t_end);
  std::vector<std::size_t> groupsOf(const std::vector<std::size_t>& bodies) const;
  std::vector<std::size_t> linkedFrom(double t) const;
  void regroup(const std::vector<std::size_t>& bodies, double t, bool anew = false);
  void restartGroup(std::size_t body);
  void disturb(std::size_t body);
  State sampleLinking(double t) const;
  BodyState bodyAt(std::size_t body, double t) const;
  std::vector<double> lawStates() const;

  std::shared_ptr<const World> world_;
  std::shared_ptr<const State> start_;
  LawTable laws_;
  MethodPlanner planner_;
  std::vector<LawWatch> watches_;  // of laws that may begin to act
  std::int64_t steps_ = 0;
  double time_ = 0;
  std::vector<double> law_states_;         // State::laws; of laws that act, as old as their group
  std::vector<WrenchSchedule> schedules_;  // one per body
  std::vector<Group> groups_;
  std::vector<double> known_until_;     // Group's, index by index; or kNotKnown
  std::vector<std::size_t> group_of_;   // body -> index in groups_; ignored for a fixed body
  std::vector<std::size_t> member_of_;  // body -> index among the members of its group; likewise
  double next_link_ = kNever;           // [s] when wrenches link or part
  double watch_from_ = kNever;          // [s] when laws may begin or cease to act
  std::set<std::size_t> near_;  // contacts that link bodies without acting; of the present step
  std::vector<ContactEvent> contact_events_;
  std::int64_t contact_events_step_ = 0;  // the step at the end of which they hold
  Step step_;
  int max_substeps_ = 1;          // of groups that are no more
  std::int64_t evaluations_ = 0;  // likewise
};

}  // namespace rigid_body_sim
