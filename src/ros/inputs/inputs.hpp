#pragma once

#include <string>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// The one way by which the node changes its run: every input that is applied is told on ~inputs,
/// with the step it came at, while somebody listens.
class Inputs {
 public:
  /// Simulation and origin are watched, not copied.
  Inputs(Topic<Input> topic, const std::string& world_frame, Simulation& simulation,
         const TimeOrigin& origin);

  /// As applyInput. Fills in header, run, number, step and time.
  void apply(Input input);

  /// Of the state that the simulation is in.
  ros::Time stamp() const { return origin_.stamp(simulation_.time()); }

 private:
  std::string world_frame_;
  Simulation& simulation_;
  const TimeOrigin& origin_;
  std::uint32_t run_ = 0;
  std::uint64_t number_ = 0;
  Topic<Input> topic_;
};

}  // namespace rigid_body_sim
