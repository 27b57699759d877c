#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/input.hpp>

#include "dynamics/run/balance.hpp"
#include "dynamics/run/group.hpp"

namespace rigid_body_sim {

/// A run that left the finite numbers or the range of its method.
class SimulationDiverged : public std::runtime_error {
 public:
  SimulationDiverged(double time, const std::string& body, const std::string& quantity);
  double time;           ///< [s] of the last good state
  std::string body;      ///< name
  std::string quantity;  ///< what failed, such as "angular momentum is no longer finite"
};

/// What a run is estimated to have got wrong so far, the worst of all bodies.
struct ErrorEstimate {
  double attitude = 0;  ///< [rad]
  double position = 0;  ///< [m]
};

/// Advances a world by its fixed time step. Time is step count × step, never accumulated.
/// Wrenches start and end at their exact instants, whatever the step. Bodies that do not act on one
/// another are advanced apart. A copy goes on by itself.
class Simulation {
 public:
  /// Wrenches that may act or be to come, of all bodies together.
  static constexpr std::size_t kMostWrenches = 100000;

  /// Throws std::invalid_argument for an integrator that is unknown or refuses a wrench of the
  /// world.
  Simulation(World world, State initial);

  const World& world() const { return *world_; }

  /// The present. A motion that is solved is evaluated here, where somebody asks, and not at every
  /// step: for two threads at once that is not, though const.
  const State& state() const;

  double time() const { return state_.t; }
  std::int64_t steps() const { return steps_; }

  /// One time step. Throws SimulationDiverged; then nothing has happened, to any body.
  void step();

  /// The state at a time between now and the next step; the run goes on as if never asked. Throws
  /// SimulationDiverged.
  State sample(double t) const;

  /// Takes an input over, now. Throws std::invalid_argument, and leaves all as it was, for one that
  /// breaks a rule: an unknown or fixed body, numbers that are not finite, a wrench that the
  /// integrator does not accept or one more than may be.
  void apply(const SimulationInput& input);

  /// Applies a wrench to a body that is not fixed; see WrenchSchedule::put for slots. Throws
  /// std::invalid_argument, and leaves all as it was, for one that the integrator does not accept,
  /// and for one more than may be.
  void applyWrench(const std::string& slot, const PointWrench& wrench);

  /// Whether the wrench would take the place of another, at once, so that there is not one more.
  bool replaces(const std::string& slot, const PointWrench& wrench) const;

  /// Ends, now, every wrench, those of a slot of every body, those of a body, or of one slot of it.
  /// Bodies on which nothing ends keep their bits.
  void clearWrenches();
  void clearWrenches(const std::string& slot);
  void clearWrenches(std::size_t body);
  void clearWrenches(std::size_t body, const std::string& slot);

  /// Number of wrenches that act now or are to come.
  std::size_t wrenchCount() const;
  std::size_t wrenchCount(std::size_t body) const { return schedules_[body].size(); }

  /// The wrenches that act on a body now.
  const std::vector<PointWrench>& activeWrenches(std::size_t body) const {
    return schedules_[body].active();
  }

  /// Sum of the wrenches applied to a body now, without gravity.
  Wrench appliedWrench(std::size_t body) const;

  /// The most parts that a step was taken in so far, because something turned, swung or decayed
  /// faster than its method follows in one; 1 when none was.
  int mostParts() const;

  /// Evaluations of all wrenches by methods so far.
  std::int64_t evaluations() const;

  /// From now on a second simulation runs along at twice the step, for half the cost: by how much
  /// the two differ tells the error (Richardson). Bodies whose motion is solved
  /// to rounding do not count; where all are, nothing runs along.
  void trackError();

  /// The greatest error so far since trackError, estimated at every other step: the difference of
  /// the two runs over 2^order − 1. Infinite once the second run has diverged.
  const ErrorEstimate& errorEstimate() const { return error_; }

  /// From now on every step is metered (ExchangeMeter), at the price of half the order and one more
  /// steps of a stepped motion, of a few evaluations of a solved one; the run keeps its bits. The
  /// balance starts anew with a body's state set from outside and with a reset.
  void trackBalance();

  /// E − E₀ − work, p − p₀ − ∫f and L − L₀ − ∫τ since the balance was started; not numbers unless
  /// it is tracked.
  Totals balance() const;

  /// Work of all that has no potential energy, impulse and angular impulse of all forces, likewise.
  Totals exchanged() const;

  /// Neither errors nor the balance are tracked from now on.
  void stopTracking();

  /// How the bodies are advanced: those that act on one another together, each group in its way.
  const std::vector<Group>& groups() const { return groups_; }

  /// Sets the state of a body that is not fixed. Starts the balance anew.
  void setState(std::size_t body, const BodyState& state);

  /// Back to the initial states, every wrench cleared, the balance started anew. Time runs on; or
  /// it starts again at zero, and with it the schedule of the scene.
  void reset(bool restart_time);

 private:
  // Bound on the work of each of auto's trial runs, in steps of one body: tenths of a second.
  static constexpr double kMostTrialSteps = 3e5;
  static constexpr double kFullTrials = 10;  // groups that may take so much; more of them share it
  static constexpr double kNotForeseen = -std::numeric_limits<double>::infinity();

  template <class... Meter>
  void stepBy(bool foreseen_too, Meter&... meter);
  template <class... Meter>
  void advance(Group& group, double t_end, std::vector<WrenchSchedule>& schedules,
               Meter&... meter) const;
  void begin(std::size_t group, double t_end);
  void takeBack();
  void accept(double t_end);
  void catchUp(std::size_t group) const;
  void trackedStep();
  void formGroups();
  void formGroupsAnew();
  void addToFormer(const Group& group);
  void restartGroup(std::size_t body);
  PointWrench onSteps(PointWrench wrench) const;
  void put(const std::string& slot, const PointWrench& wrench);
  template <class Clear>
  void clearBodies(std::size_t begin, std::size_t end, const Clear& clear);
  void disturb(std::size_t body);
  void markDisturbed(const Group& group);
  MethodChoice chosen(const CoupledBodies& bodies, unsigned needs, double most_trial_steps);
  bool solvedToRounding(const Group& group) const;
  void startCoarse();
  Simulation& ownCoarse();
  void followCoarse();
  void startBalance();

  std::shared_ptr<const World> world_;
  std::shared_ptr<const State> initial_;
  const Method* method_;       // null: auto
  mutable State state_;        // its bodies may be behind its time
  mutable bool lags_ = false;  // whether some are
  std::int64_t steps_ = 0;
  std::vector<WrenchSchedule> schedules_;  // one per body
  std::vector<Group> groups_;
  std::vector<double> foreseen_until_;  // Group's, index by index; or kNotForeseen
  std::vector<std::size_t> advanced_;   // groups that a step advances; used inside it
  std::vector<std::size_t> scheduled_;  // bodies with an event within a step; used inside it
  int most_parts_ = 1;                  // of groups that are no more
  std::int64_t evaluations_ = 0;        // likewise
  std::size_t at_most_ = 0;             // not less than wrenchCount()
  std::vector<std::size_t> group_of_;   // body -> index in groups_; of no account for a fixed body
  std::map<std::vector<std::size_t>, MethodChoice> choices_;  // of auto's trials, by members
  std::vector<bool> disturbed_;  // bodies that do not move as they did in a trial
  double most_turn_share_ = 1;   // MethodChoice's
  bool tracked_ = false;         // error or balance
  bool tracks_error_ = false;
  // at twice the step; null until a step of even count; changed only while no copy shares it
  std::shared_ptr<Simulation> coarse_;
  ErrorEstimate error_;
  std::optional<Balance> balance_;  // where it is tracked
};

}  // namespace rigid_body_sim
