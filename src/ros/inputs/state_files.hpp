#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <rigid_body_sim/StateFile.h>

#include "programs/distinct_files.hpp"
#include "ros/inputs/inputs.hpp"

namespace rigid_body_sim {

/// The services ~save and ~load.
class StateFiles {
 public:
  /// Why a run cannot go on at a simulation time [s]; empty where it can.
  using FaultOfTime = std::function<std::string(double t)>;

  /// Simulation and inputs are referred to, not copied. scene_files: what no state may replace.
  StateFiles(ros::NodeHandle private_nh, const Simulation& simulation, Inputs& inputs,
             FaultOfTime fault_of_time, std::vector<NamedFile> scene_files);

 private:
  bool save(StateFile::Request& request, StateFile::Response& response);
  bool load(StateFile::Request& request, StateFile::Response& response);

  const Simulation& simulation_;
  Inputs& inputs_;
  FaultOfTime fault_of_time_;
  std::vector<NamedFile> scene_files_;
  ros::ServiceServer save_, load_;
};

}  // namespace rigid_body_sim
