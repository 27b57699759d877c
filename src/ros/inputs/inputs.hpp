#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The one way by which the node changes its run. Every input that is applied is recorded on
/// ~inputs, with the step at which it came, while that topic has subscribers.
///
/// rosbag closes a bag on a message that comes while the clock stands at zero, as it does after
/// time has been set back: what is applied there is recorded a moment after the clock has gone on.
class Inputs {
 public:
  using Clock = std::chrono::steady_clock;
  /// How long after the first clock that is not zero: it has reached the recorder by then.
  static constexpr std::chrono::milliseconds kClockDelay{100};

  using Listener = std::function<void(const SimulationInput&)>;
  using Preparation = std::function<void()>;

  /// clock_period [s] of simulation time: of the clock that this node sends. prepare is called
  /// before each input, the listener after it. Simulation and origin are referred to, not copied.
  Inputs(Topic<Input> record, const std::string& world_frame, Simulation& simulation,
         const TimeOrigin& origin, double clock_period, Listener listener = nullptr,
         Preparation prepare = nullptr);

  /// As Simulation::apply.
  void apply(const SimulationInput& input);

  /// Records what was applied at time zero, once it may. To be called again and again.
  void recordHeld(Clock::time_point now);

  /// Of the state that the simulation is in.
  ros::Time stamp() const { return origin_.stamp(simulation_.time()); }

 private:
  void applyInTime(const SimulationInput& input);
  void record(const SimulationInput& input);

  std::string world_frame_;
  Simulation& simulation_;
  const TimeOrigin& origin_;
  double clock_period_;
  Preparation prepare_;
  Listener listener_;
  std::uint32_t run_ = 0;
  std::uint64_t number_ = 0;
  std::vector<Input> held_;                         // until the clock has left zero
  std::optional<Clock::time_point> clock_runs_at_;  // from then on it has left zero
  Topic<Input> record_;
};

}  // namespace rigid_body_sim
