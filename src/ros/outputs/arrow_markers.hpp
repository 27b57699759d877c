#pragma once

#include <string>
#include <vector>

#include <visualization_msgs/Marker.h>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// [m] How large a body is: the diameter of the homogeneous ball that has its mass and the sum of
/// its moments,  2 √(5 (I₁ + I₂ + I₃) / (6 m)).
double sizeOf(const Body& body);

/// Arrows in the world that show what acts on a body and how it turns; without header and id, in
/// the namespaces wrench/force, wrench/couple, actuator/force, actuator/torque, contact/normal,
/// contact/friction and motion/angular_momentum:
///   a force and a couple, each from the point at which the wrench acts,
///   the force of a thruster or rotor from its place, the torque of a wheel on the body from the
///   centre of mass,
///   normal and friction force on the body that touches, from the place where it touches,
///   the angular momentum from the centre of mass, or from the pivot.
/// An arrow is as long as the body (sizeOf) for a force equal to the weight on Earth, a couple
/// equal to the weight on half a body's size, and the angular momentum of half a turn a second
/// about the axis of the greatest moment. Length goes with the square root of the magnitude, from a
/// tenth of the body to three times the body, so that a thruster and a blow can be seen in one
/// picture. What is beyond twelve decimal digits below those has no arrow: it is rounding.
std::vector<visualization_msgs::Marker> wrenchArrows(const PointWrench& applied,
                                                     const std::vector<Body>& bodies,
                                                     const std::vector<BodyState>& states);
/// Those of actuators are in the body's frame, with which rviz moves them.
std::vector<visualization_msgs::Marker> actuatorArrows(
    const Body& body, const std::string& body_frame, const std::vector<ActuatorReading>& readings);
std::vector<visualization_msgs::Marker> contactArrows(const ContactPoint& contact,
                                                      const std::vector<Body>& bodies);
std::vector<visualization_msgs::Marker> momentumArrows(const Body& body, const BodyState& state);

}  // namespace rigid_body_sim
