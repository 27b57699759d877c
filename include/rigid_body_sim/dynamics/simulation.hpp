#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/input.hpp>
#include <rigid_body_sim/dynamics/totals.hpp>

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
  /// [s] With auto: since when the estimate, of attitude or, of a body that has come further than
  /// its size, of position relative to its path, exceeds the tolerance; infinite while it does not.
  double lost_at = std::numeric_limits<double>::infinity();
};

/// What auto has found before the run of a scene with contact or tethers, which states a tolerance.
/// Impacts, and pulls that begin suddenly, magnify errors, so that the scene is run up to its
/// horizon beside two others:
///   a looser run, bounds 100 times as loose, from which it may differ by the tolerance; only with
///   contact;
///   a tighter run, bounds 100 times as tight and steps half as long, from which it may differ by a
///   quarter of the tolerance; only where forces other than contact act.
/// Where the runs differ by more, all are made anew at bounds 100 times tighter, down to 1e-14;
/// below, rounding decides. The work is bounded, to tenths of a second; where that ends before a
/// tenth of the time up to the horizon, the bound stays what it was at first.
/// Runs are compared after every step, and of contact alone at 32 instants up to the horizon at
/// least.
struct ContactTrial {
  /// What the error estimate of a step in contact may reach; of a step out of contact that is
  /// divided by estimates, bounds are changed in the same proportion.
  double step_bound = 0;
  /// [s] Since when the tolerance was exceeded at that bound; infinite where it was not.
  double lost_at = std::numeric_limits<double>::infinity();
  /// [s] Up to when the scene was tried, at that bound or a tighter one; the start where it was
  /// not.
  double tried_until = 0;
  bool is_made = false;   ///< whether it was tried
  bool compares = false;  ///< and came so far that the two runs were compared
  /// Whether bodies came under other forces than those with which their integrators were tried one
  /// by one at the start. Then such bodies go by error estimates from the start on.
  bool regroups = false;
};

/// Advances a world by its fixed time step. Time is step count × step, never accumulated.
/// Wrenches start and end at their exact instants, whatever the step. Bodies that do not act on one
/// another are advanced separately. Copies are independent: two threads may run two of them, and
/// read one. Indices of bodies and times that are out of range throw std::invalid_argument.
class Simulation {
 public:
  /// Wrenches that may act or be to come, of all bodies together.
  static constexpr std::size_t kMaxWrenches = 100000;

  /// Commands that may be to come, of all bodies together.
  static constexpr std::size_t kMaxCommands = 100000;

  /// From a state of the world on: of the start, or as state() gave it, of any step; then the same
  /// bits follow as in the run that it is from. Throws std::invalid_argument for a world or a state
  /// that break a rule: an integrator that is unknown or does not support what acts, a time step
  /// that is not > 0, sizes and indices that do not match, attitudes that are not unit, numbers
  /// that are not finite, a time that is no multiple of the step.
  Simulation(World world, State start);
  Simulation(const Simulation& other);
  /// What was moved from may only be assigned to or destroyed.
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(const Simulation& other);
  Simulation& operator=(Simulation&& other) noexcept;
  ~Simulation();

  /// As it is now: setMassProperties, setPresent, reset and load may change bodies and what goes by
  /// them; then this is another object.
  const World& world() const;

  /// How often world() became another object since the start; references into it are then stale.
  std::size_t worldChanges() const;
  double time() const;  ///< [s] since the start, steps() × step
  std::int64_t steps() const;

  /// The state now, of one body or of all: a solved motion is evaluated here, and not at every
  /// step.
  BodyState body(std::size_t body) const;
  State state() const;

  /// State::bodies of state(), at a fraction of its cost; readBodies reuses the memory of `states`,
  /// which of many bodies is a good part of it.
  std::vector<BodyState> bodies() const;
  void readBodies(std::vector<BodyState>& states) const;

  /// The state at a time between now and the next step; the run goes on as if never asked. Throws
  /// SimulationDiverged.
  State sample(double t) const;

  /// How bodies, fixed ones too, move and accelerate at a time between now and the next step, in
  /// the order of these indices. Nothing is computed of any other body.
  std::vector<BodyMotion> motions(const std::vector<std::size_t>& bodies, double t) const;

  /// One time step. Throws SimulationDiverged; then nothing has happened, to any body.
  void step();

  /// So many time steps, faster than one by one: bodies that nothing disturbs are taken through
  /// several steps while they are in the processor's cache, with the same bits. Throws
  /// SimulationDiverged after those steps that could be taken.
  void step(std::int64_t count);

  /// The same, and readBodies: bodies that are stepped several at a time are read while they are in
  /// the processor's cache. After SimulationDiverged `states` may be anything.
  void step(std::int64_t count, std::vector<BodyState>& states);

  /// Takes an input over, now. Throws std::invalid_argument, and leaves all as it was, for one that
  /// breaks a rule: an unknown or fixed body, numbers that are not finite, a wrench that the
  /// integrator does not support or one more than may be.
  void apply(const SimulationInput& input);

  /// The same by their parts; see WrenchInput, ClearInput, StateInput, ResetInput, CommandInput,
  /// WindInput, MassInput, PresenceInput. Bodies on which nothing changes keep their bits. A state
  /// that is set leaves the speeds of wheels and rotors relative to the body as they are, and L_W
  /// follows from them. A command that would have started before starts now. velocity_W [m/s]: of
  /// the medium; a world without one refuses it.
  void applyWrench(const std::string& slot, const PointWrench& wrench);
  void clearWrenches(std::size_t body = ClearInput::kEveryBody, const std::string& slot = "");
  void setState(std::size_t body, const BodyState& state);
  void reset(bool restart_time);
  void command(const ActuatorCommand& command);
  void setWind(const Vector3d& velocity_W);

  /// Other mass properties of a body that moves, from now on and until a reset or load. The body
  /// stays where it is, and keeps its momentum p and its angular momentum about the world's origin,
  /// to the last bit where its centre of mass stays in place; v = p/m and ω = I⁻¹ L are others. Of
  /// wheels and rotors the momentum h and the speed Ω are kept; on a pivot L about the pivot, and
  /// the pivot takes up the change of p. What is attached stays at its point of the body: wrenches,
  /// springs, tethers, shapes that touch, buoyancy, motors; drag without a centre, and gravity, act
  /// at the new centre of mass. Friction stays as stiff as for the mass of the scene. The balance
  /// counts the change of energy as work. Throws std::invalid_argument, and leaves all as it was,
  /// for what has a fault (massPropertiesFault, actuatorsFault).
  void setMassProperties(std::size_t body, const MassProperties& properties_B);

  /// A body that is absent comes in, with a state and its motors as they start; or, without a
  /// state, one that is present leaves. While it is absent nothing acts on it and it acts on
  /// nothing: springs, tethers and contacts to it rest, wrenches on it are refused, and it counts
  /// in no energy or momentum. Where it leaves, wrenches and commands on it end, and wrenches that
  /// turn with it; others keep their bits unless it acted on them. Contacts and tethers start anew
  /// where it comes in. The balance counts its energy and momenta as exchanged. Until a reset or
  /// load. Throws std::invalid_argument, and leaves all as it was, for a body that is fixed or
  /// where it is to be already.
  void setPresent(std::size_t body, const std::optional<BodyState>& state);

  /// On from a state as state() gave it, of this run or another of the same world, which is the
  /// caller's to know (loadState of state_file.hpp compares): the same bits follow as there. A
  /// reset still leads to the start of this run. Throws std::invalid_argument, and leaves all as it
  /// was, for a state that breaks a rule.
  void load(const State& state);

  /// Throws std::invalid_argument where applyWrench would, for one of these applied in order.
  void checkWrenches(const std::vector<WrenchInput>& wrenches) const;

  /// Whether the wrench would take the place of another, at once, so that there is not one more.
  bool replaces(const std::string& slot, const PointWrench& wrench) const;

  /// Number of wrenches that act now or are to come, of all bodies or of one.
  std::size_t wrenchCount() const;
  std::size_t wrenchCount(std::size_t body) const;

  /// The wrenches that act on a body now.
  const std::vector<PointWrench>& activeWrenches(std::size_t body) const;

  /// Those that act on a body at a time t [s] between now and the next step.
  std::vector<PointWrench> activeWrenches(std::size_t body, double t) const;

  /// Touches and releases within the last step, in order; of the start, before the first step.
  const std::vector<ContactEvent>& contactEvents() const;

  /// What the actuators of a body do now, in the order of Body::actuators; at another time, by
  /// readActuators of a sample.
  std::vector<ActuatorReading> actuators(std::size_t body) const;

  /// Commands so far that were beyond the limits of their actuator.
  std::int64_t saturations() const;

  /// Sum of the wrenches applied to a body now, without gravity, laws and actuators.
  Wrench appliedWrench(std::size_t body) const;

  /// How the bodies are advanced, group by group.
  std::vector<MotionPlan> plans() const;

  /// How steps in contact are bounded. In a scene without contact and tethers it means nothing.
  ContactTrial contactTrial() const;

  /// [s] From when the scene's horizon counts: 0, or, where a reset has let time run on, later by
  /// as much as the run began anew after its start.
  double horizonBegins() const;

  /// Largest number of substeps that a step was divided into so far, because something turned,
  /// swung or decayed faster than its method follows in one; 1 when none was.
  int maxSubsteps() const;

  /// ln of the factor by which the integrator has magnified, so far, what a body turns about its
  /// axis of least inertia; of all bodies the greatest: ∫ ½ h (ω·L/I₁ − |ω|²) dt under
  /// semi_implicit_euler, 0 under the others. At some 30, rounding has become a visible motion.
  double magnification() const;

  /// Evaluations of all wrenches by integrators so far.
  std::int64_t evaluations() const;

  /// From now on a second simulation runs along at twice the step, for half the cost: the
  /// difference of the two shows the error (Richardson). Bodies whose motion is solved to rounding
  /// do not count; where all are, nothing runs along.
  void trackError();

  /// The greatest error so far since trackError, estimated at every other step: the difference of
  /// the two runs over 2^order − 1, of the integrator of the body, or of dop853 where it is solved
  /// between the pulls of a tether; with contact, and of another solved body, the difference
  /// itself. Infinite once the second run has diverged; 0 where nothing is tracked.
  ErrorEstimate errorEstimate() const;

  /// From now on every step is metered: costs order/2 + 1 extra steps per integrated step, a few
  /// evaluations of a solved motion; the run keeps its bits. The balance starts anew with a body's
  /// state set from outside and with a reset.
  void trackBalance();

  /// E − E₀ − work, p − p₀ − ∫f and L − L₀ − ∫τ since the balance was started; not numbers unless
  /// it is tracked.
  Totals balance() const;

  /// Work of all that has no potential energy, impulse and angular impulse of all forces, likewise.
  Totals exchanged() const;

  /// Neither errors nor the balance are tracked from now on.
  void stopTracking();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigid_body_sim
