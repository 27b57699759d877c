#pragma once

#include <ros/node_handle.h>

#include <rigid_body_sim/scene/scene.hpp>

#include "ros/inputs/command_interfaces.hpp"
#include "ros/inputs/input_context.hpp"
#include "ros/inputs/mass_service.hpp"
#include "ros/inputs/presence_service.hpp"
#include "ros/inputs/state_files.hpp"
#include "ros/inputs/state_services.hpp"
#include "ros/inputs/wind_interface.hpp"
#include "ros/inputs/wrench_interfaces.hpp"
#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// Every topic and service through which inputs come, but for the mouse and the run of time:
/// wrenches, commands, wind, mass properties, bodies that come in or leave, states.
class InputInterfaces {
 public:
  /// What the context refers to must outlive it.
  InputInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const Scene& scene,
                  const NodeOptions& options, const InputContext& context,
                  StateFiles::FaultOfTime fault_of_time);

  /// To be called after every input that may have changed mass properties.
  void followBodies() { wrenches_.followBodies(); }

 private:
  WrenchInterfaces wrenches_;
  CommandInterfaces commands_;
  WindInterface wind_;
  MassService mass_;
  PresenceService presence_;
  StateServices states_;
  StateFiles state_files_;
};

}  // namespace rigid_body_sim
