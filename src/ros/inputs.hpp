#pragma once

#include <string>

#include <ros/node_handle.h>

#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "conversions.hpp"

namespace rigid_body_sim {

/// The one way by which the node changes its run: every input that is applied is told on ~inputs,
/// with the step it came at, while somebody listens.
class Inputs {
 public:
  /// Simulation and origin are watched, not copied.
  Inputs(ros::NodeHandle private_nh, const std::string& world_frame, Simulation& simulation,
         const TimeOrigin& origin);

  /// As applyInput. Fills in header, run, number, step and time.
  void apply(Input input);

 private:
  std::string world_frame_;
  Simulation& simulation_;
  const TimeOrigin& origin_;
  std::uint32_t run_ = 0;
  std::uint64_t number_ = 0;
  ros::Publisher publisher_;
};

}  // namespace rigid_body_sim
