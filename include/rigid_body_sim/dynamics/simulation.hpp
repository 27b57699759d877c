#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// A run that left the finite numbers or the range of its method.
class SimulationDiverged : public std::runtime_error {
 public:
  SimulationDiverged(double time, std::string body, std::string quantity);
  double time;           ///< [s] of the last good state
  std::string body;      ///< name
  std::string quantity;  ///< what failed, such as "angular momentum is not finite"
};

/// Advances a world by its fixed time step. Time is step count × step, never accumulated.
/// Wrenches start and end at their exact instants, whatever the step.
class Simulation {
 public:
  /// Throws std::invalid_argument for an integrator that is unknown or cannot take the world.
  Simulation(World world, State initial);

  const World& world() const { return world_; }
  const State& state() const { return state_; }
  double time() const { return state_.t; }
  std::int64_t steps() const { return steps_; }

  /// One time step. Throws SimulationDiverged and keeps the last finite state.
  void step();

  /// The state at a time between now and the next step; the run itself goes on as if never asked.
  State sample(double t) const;

  /// Applies a wrench. It replaces that of the same body and slot from its own start on; an empty
  /// slot always adds. A start in the past means now.
  void applyWrench(const std::string& slot, const AppliedWrench& wrench);

  /// Ends, now, the wrenches of a body, or of the one slot of it.
  void clearWrenches(std::size_t body);
  void clearWrenches(std::size_t body, const std::string& slot);
  void clearWrenches();

  /// Number of wrenches that act now or are to come.
  std::size_t wrenchCount() const;

  /// Sum of the wrenches applied to a body now, without gravity.
  Wrench appliedWrench(std::size_t body) const;

  void setState(std::size_t body, const BodyState& state);

  /// Back to the initial states, every wrench cleared. Time runs on; or it starts again at zero,
  /// and with it the schedule of the scene.
  void reset(bool restart_time);

 private:
  World world_;
  State initial_;
  State state_;
  std::int64_t steps_ = 0;
};

}  // namespace rigid_body_sim
