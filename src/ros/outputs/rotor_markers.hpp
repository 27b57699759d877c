#pragma once

#include <string>
#include <vector>

#include <visualization_msgs/Marker.h>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// [m] How large a rotor is drawn: the diameter at which a propeller in air has its thrust,
///   thrust = C ρ D⁴ / (4 π²),  C = 0.1, ρ = 1.2 kg/m³,
/// but a tenth of the body at least, and the body at most. The scene does not say how large it is.
double rotorDiameter(const Rotor& rotor, const Body& body);

/// The rotors of a body in rviz, in the body's frame: a blade that turns, in a disc that one sees
/// through. In the namespaces rotor/blade and rotor/disc, without ids.
class RotorMarkers {
 public:
  RotorMarkers(std::string body_frame, Body body);

  /// At a time t [s], at the speeds of the readings. Between two calls each has turned at the mean
  /// of its two speeds; of a fast one the eye sees what a camera with this many pictures would.
  std::vector<visualization_msgs::Marker> at(double t,
                                             const std::vector<ActuatorReading>& readings);

 private:
  std::string body_frame_;
  Body body_;
  double t_ = 0;
  std::vector<double> angles_;  // [rad] about the direction, by actuator
  std::vector<double> speeds_;  // [rad/s] in the sense in which the rotor turns
};

}  // namespace rigid_body_sim
