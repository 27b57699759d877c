#include "ros/outputs/arrow_markers.hpp"

#include <algorithm>
#include <cmath>

#include "math/wide.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

constexpr double kStandardGravity = 9.80665;  // [m/s²]
constexpr double kShortest = 0.1;             // of a body's size
constexpr double kLongest = 3.0;
constexpr double kRounding = 1e-12;
constexpr double kHalfATurn = kPi<double>;  // [rad/s]

/// How one kind of arrow looks.
struct Kind {
  const char* name_space;
  float r, g, b;
};
constexpr Kind kForce{"wrench/force", 0.9F, 0.2F, 0.2F};
constexpr Kind kCouple{"wrench/couple", 0.9F, 0.8F, 0.2F};
constexpr Kind kActuatorForce{"actuator/force", 0.95F, 0.45F, 0.75F};
constexpr Kind kActuatorTorque{"actuator/torque", 0.6F, 0.4F, 0.9F};
constexpr Kind kNormal{"contact/normal", 0.2F, 0.8F, 0.3F};
constexpr Kind kFriction{"contact/friction", 0.9F, 0.5F, 0.1F};
constexpr Kind kAngularMomentum{"motion/angular_momentum", 0.2F, 0.8F, 0.8F};

Marker arrow(const Kind& kind, const Vector3d& tail_W, const Vector3d& along_W, double size) {
  const double length = along_W.norm();
  const double thickness = std::min(0.1 * length, 0.04 * size);
  Marker marker;
  marker.type = Marker::ARROW;
  marker.ns = kind.name_space;
  marker.points = {toPoint(tail_W), toPoint(tail_W + along_W)};
  marker.pose.orientation.w = 1;
  marker.scale = toVector3({thickness, 2.5 * thickness, 5 * thickness});  // shaft, head, its length
  marker.color.r = kind.r;
  marker.color.g = kind.g;
  marker.color.b = kind.b;
  marker.color.a = 1;
  return marker;
}

/// Adds the arrow of a vector, `whole` of which is as long as the body.
void addArrow(const Kind& kind, const Vector3d& tail_W, const Vector3d& v_W, double whole,
              double size, std::vector<Marker>& arrows) {
  const double share = v_W.norm() / whole;
  if (!(share > kRounding)) return;
  const double length = size * std::clamp(std::sqrt(share), kShortest, kLongest);
  arrows.push_back(arrow(kind, tail_W, length * v_W.normalized(), size));
}

}  // namespace

double sizeOf(const Body& body) {
  const double about_com = body.I.sum() - 2 * body.mass * body.com_P.squaredNorm();
  return 2 * std::sqrt(5 * std::max(about_com, 0.01 * body.I.sum()) / (6 * body.mass));
}

std::vector<Marker> wrenchArrows(const PointWrench& applied, const std::vector<Body>& bodies,
                                 const std::vector<BodyState>& states) {
  const Body& body = bodies[applied.body];
  const double size = sizeOf(body);
  const double weight = body.mass * kStandardGravity;
  const Vector3d point_W = states[applied.body].x_W + armOf(applied, states);
  std::vector<Marker> arrows;
  addArrow(kForce, point_W, toWorldAxes(applied, applied.force, states), weight, size, arrows);
  addArrow(kCouple, point_W, toWorldAxes(applied, applied.torque, states), weight * size / 2, size,
           arrows);
  return arrows;
}

std::vector<Marker> actuatorArrows(const Body& body, const std::string& body_frame,
                                   const std::vector<ActuatorReading>& readings) {
  const double size = sizeOf(body);
  const double weight = body.mass * kStandardGravity;
  std::vector<Marker> arrows;
  const auto addForce = [&](const auto& actuator, const ActuatorReading& reading) {
    addArrow(kActuatorForce, actuator.position_B, reading.force * actuator.direction_B, weight,
             size, arrows);
  };
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto& kind = body.actuators[i].kind;
    if (const auto* thruster = std::get_if<Thruster>(&kind)) addForce(*thruster, readings[i]);
    if (const auto* rotor = std::get_if<Rotor>(&kind)) addForce(*rotor, readings[i]);
    const auto* wheel = std::get_if<Wheel>(&kind);
    if (!wheel) continue;
    const Vector3d torque_B = -readings[i].torque * wheel->axis_B;  // on the body
    addArrow(kActuatorTorque, body.X_BP * body.com_P, torque_B, weight * size / 2, size, arrows);
  }
  for (Marker& arrow : arrows) {
    arrow.header.frame_id = body_frame;  // at its latest pose: no stamp
    arrow.frame_locked = true;
  }
  return arrows;
}

std::vector<Marker> contactArrows(const ContactPoint& contact, const std::vector<Body>& bodies) {
  const Body& body = bodies[contact.body];
  const double size = sizeOf(body);
  const double weight = body.mass * kStandardGravity;
  std::vector<Marker> arrows;
  addArrow(kNormal, contact.position_W, contact.normal_force_W, weight, size, arrows);
  addArrow(kFriction, contact.position_W, contact.friction_force_W, weight, size, arrows);
  return arrows;
}

std::vector<Marker> momentumArrows(const Body& body, const BodyState& state) {
  std::vector<Marker> arrows;
  addArrow(kAngularMomentum, state.x_W, state.L_W, kHalfATurn * body.I.maxCoeff(), sizeOf(body),
           arrows);
  return arrows;
}

}  // namespace rigid_body_sim
