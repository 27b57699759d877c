#include "ros/outputs/rotor_markers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/wide.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/outputs/arrow_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

/// The shortest turn that takes the axis z to the unit vector d.
Quaterniond turnFromZ(const Vector3d& d) {
  const double across = std::hypot(d.x(), d.y());
  if (across == 0) return d.z() < 0 ? Quaterniond(0, 1, 0, 0) : Quaterniond(1, 0, 0, 0);
  const Vector3d axis(-d.y() / across, d.x() / across, 0);
  return rotationExp(Vector3d(std::atan2(across, d.z()) * axis));
}

Marker rotorMarker(const char* name_space, int type, const std::string& body_frame,
                   const Rotor& rotor, double angle, const Vector3d& size, float opacity) {
  const Quaterniond along = turnFromZ(rotor.direction_B);
  const Quaterniond turned(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
  Marker marker;
  marker.ns = name_space;
  marker.type = type;
  marker.header.frame_id = body_frame;  // at its latest pose: no stamp
  marker.frame_locked = true;
  marker.pose.position = toPoint(rotor.position_B);
  marker.pose.orientation = toQuaternion(along * turned);
  marker.scale = toVector3(size);
  marker.color.r = marker.color.g = marker.color.b = 0.8F;
  marker.color.a = opacity;
  return marker;
}

}  // namespace

double rotorDiameter(const Rotor& rotor, const Body& body) {
  constexpr double kThrustOfDiameter = 0.1 * 1.2 / (4 * kPi<double> * kPi<double>);
  const double size = sizeOf(body);
  return std::clamp(std::pow(rotor.thrust / kThrustOfDiameter, 0.25), 0.1 * size, size);
}

RotorMarkers::RotorMarkers(std::string body_frame, Body body)
    : body_frame_(std::move(body_frame)),
      body_(std::move(body)),
      angles_(body_.actuators.size()),
      speeds_(body_.actuators.size()) {}

std::vector<Marker> RotorMarkers::at(double t, const std::vector<ActuatorReading>& readings) {
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto* rotor = std::get_if<Rotor>(&body_.actuators[i].kind);
    if (!rotor) continue;
    const double speed = rotor->turns * readings[i].speed;
    const double turned = std::max(t - t_, 0.0) * (speeds_[i] + speed) / 2;  // time may be set back
    angles_[i] = std::remainder(angles_[i] + turned, 2 * kPi<double>);
    speeds_[i] = speed;
    const double d = rotorDiameter(*rotor, body_);
    markers.push_back(rotorMarker("rotor/blade", Marker::CUBE, body_frame_, *rotor, angles_[i],
                                  {d, 0.1 * d, 0.02 * d}, 1));
    markers.push_back(rotorMarker("rotor/disc", Marker::CYLINDER, body_frame_, *rotor, 0,
                                  {d, d, 0.01 * d}, 0.15F));
  }
  t_ = t;
  return markers;
}

}  // namespace rigid_body_sim
