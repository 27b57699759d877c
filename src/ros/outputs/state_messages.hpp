#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/AccelStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <sensor_msgs/JointState.h>

#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/dynamics/acceleration.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// A message with the names of these bodies of the world, whose states setBodyStates sets.
BodyStates emptyBodyStates(const World& world, const std::vector<std::size_t>& bodies,
                           const std::string& world_frame);

/// Sets pose and twist of these bodies, those of the message, and the stamp. states: by body of the
/// world.
void setBodyStates(const World& world, const std::vector<std::size_t>& bodies,
                   const std::vector<BodyState>& states, const ros::Time& stamp,
                   BodyStates& message);

/// A wrench on a body in body axes, about the centre of mass:
///   f_B = R_BP R_WPᵀ f_W,   τ_B = R_BP (R_WPᵀ tau_W + tau_P).
geometry_msgs::WrenchStamped toWrenchStamped(const Body& body, const BodyState& state,
                                             const Wrench& wrench, const ros::Time& stamp);

/// Acceleration of the origin of the body frame against the world, gravity included, and angular
/// acceleration, in body axes:
///   R_WBᵀ accelerationOf(origin),   R_BP ω'.
geometry_msgs::AccelStamped toAccelStamped(const Body& body, const BodyMotion& motion,
                                           const ros::Time& stamp);

/// The force of its pivot on a body in body axes, at the pivot; see pivotForceOf. The torque is
/// zero.
geometry_msgs::WrenchStamped toPivotForce(const Body& body, const BodyMotion& motion,
                                          const ros::Time& stamp);

/// What the actuators of a body do, in the order of Body::actuators. Velocity: speed of a rotor or
/// wheel relative to the body, 0 of a thruster. Effort: force of a thruster or rotor, torque of a
/// wheel's motor on the wheel. No positions.
sensor_msgs::JointState toJointState(const Body& body, const std::vector<ActuatorReading>& readings,
                                     const ros::Time& stamp);

}  // namespace rigid_body_sim
