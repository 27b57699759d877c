#pragma once

#include <geometry_msgs/Inertia.h>
#include <ros/node_handle.h>

#include <rigid_body_sim/SetMassProperties.h>

#include "ros/inputs/input_context.hpp"

namespace rigid_body_sim {

geometry_msgs::Inertia toInertia(const MassProperties& properties_B);

/// What ~set_mass_properties asks for. Throws std::invalid_argument, one line, for an unknown body.
MassInput takeMassProperties(const SetMassProperties::Request& request, const World& world);

/// The service ~set_mass_properties.
class MassService {
 public:
  /// What the context refers to must outlive it.
  MassService(ros::NodeHandle private_nh, const InputContext& context);

 private:
  bool set(SetMassProperties::Request& request, SetMassProperties::Response& response);

  InputContext context_;
  ros::ServiceServer server_;
};

}  // namespace rigid_body_sim
