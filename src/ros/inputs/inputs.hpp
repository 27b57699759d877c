#pragma once

#include <functional>
#include <string>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The one way by which the node changes its run. Every input that is applied is recorded on
/// ~inputs, with the step at which it came, while that topic has subscribers.
class Inputs {
 public:
  using Listener = std::function<void(const SimulationInput&)>;

  /// The listener is called after each input. Simulation and origin are referred to, not copied.
  Inputs(Topic<Input> record, const std::string& world_frame, Simulation& simulation,
         const TimeOrigin& origin, Listener listener = nullptr);

  /// As Simulation::apply.
  void apply(const SimulationInput& input);

  /// Of the state that the simulation is in.
  ros::Time stamp() const { return origin_.stamp(simulation_.time()); }

 private:
  void record(const SimulationInput& input);

  std::string world_frame_;
  Simulation& simulation_;
  const TimeOrigin& origin_;
  Listener listener_;
  std::uint32_t run_ = 0;
  std::uint64_t number_ = 0;
  Topic<Input> record_;
};

}  // namespace rigid_body_sim
