#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

/// What the pilot knows about the quadrotor of config/scenes/quadrotor.yaml.
struct Quadrotor {
  struct Rotor {
    const char* name;
    double x_side, y_side;  ///< +1: in front, on the left
    double turn;            ///< +1: ccw, -1: cw
  };
  std::array<Rotor, 4> rotors{{{"front_left", 1, 1, 1},
                               {"rear_left", -1, 1, -1},
                               {"rear_right", -1, -1, 1},
                               {"front_right", 1, -1, -1}}};
  double arm = 0.17;                               ///< [m] of each rotor, along x and along y
  double mass = 1.2;                               ///< [kg]
  Eigen::Vector3d inertia{0.0095, 0.0105, 0.018};  ///< [kg m²] about the body axes
  double thrust = 8.5e-6;                          ///< [N s²/rad²] over speed squared
  double drag_torque = 1.4e-7;                     ///< [N m s²/rad²] likewise
};

/// Where a quadrotor is and how it moves, as odometry says.
struct Motion {
  Eigen::Vector3d position;          ///< [m] in the world
  Eigen::Quaterniond attitude;       ///< body to world
  Eigen::Vector3d velocity_body;     ///< [m/s] body axes
  Eigen::Vector3d angular_velocity;  ///< [rad/s] body axes
};

/// A point of the path to be flown: world axes.
struct PathPoint {
  Eigen::Vector3d position, velocity, acceleration;
};

/// A level circle about the z axis, after some seconds at its start. The angle along the circle
/// grows as t² at first, then as t.
class CirclePath {
 public:
  PathPoint at(double time) const {
    const double t = std::max(time - hover, 0.0);
    const bool speeds_up = t < speed_up;
    const double angle = rate * (speeds_up ? t * t / (2 * speed_up) : t - speed_up / 2);
    const double angle_rate = rate * std::min(t / speed_up, 1.0);
    const double angle_acceleration = speeds_up && t > 0 ? rate / speed_up : 0;
    const Eigen::Vector3d outward(std::cos(angle), std::sin(angle), 0);
    const Eigen::Vector3d along(-std::sin(angle), std::cos(angle), 0);
    return {radius * outward + height * Eigen::Vector3d::UnitZ(), radius * angle_rate * along,
            radius * (angle_acceleration * along - angle_rate * angle_rate * outward)};
  }

  double radius = 1.5, height = 1.0;  ///< [m]
  double rate = 1.2;                  ///< [rad/s] round the circle
  double hover = 2, speed_up = 2;     ///< [s]
};

/// Flies along a path, the nose along the x axis of the world. Two laws of the form of a damped
/// spring, ζ and w their damping ratio and frequency:
///
///   acceleration wanted of the thrust   a = a_path + 2 ζ w (v_path − v) + w² (x_path − x) − g
///   torque                              τ = I (w² e − 2 ζ w ω),  e: the rotation from the thrust
///                                       axis to a, and the heading back to zero
class Pilot {
 public:
  /// Speeds of the rotors [rad/s], in the order of Quadrotor::rotors.
  std::array<double, 4> speeds(const PathPoint& path, const Motion& now) const {
    const Eigen::Matrix3d R = now.attitude.toRotationMatrix();
    const Eigen::Vector3d a =
        path.acceleration + 2 * damping * path_rate * (path.velocity - R * now.velocity_body) +
        path_rate * path_rate * (path.position - now.position) + Eigen::Vector3d(0, 0, 9.80665);
    const Eigen::Vector3d up = R.transpose() * a.normalized();
    const Eigen::Vector3d e(-up.y(), up.x(), -std::atan2(R(1, 0), R(0, 0)));
    const Eigen::Array3d w(tilt_rate, tilt_rate, heading_rate);
    const Eigen::Vector3d torque =
        drone.inertia.array() *
        (w * w * e.array() - 2 * damping * w * now.angular_velocity.array());
    return speedsFor(drone.mass * a.dot(R.col(2)), torque);
  }

  Quadrotor drone;
  double damping = 0.9;
  double path_rate = 2.5;   ///< [rad/s]
  double tilt_rate = 10;    ///< [rad/s]
  double heading_rate = 2;  ///< [rad/s]

 private:
  /// Each rotor takes a quarter of the thrust, and of each torque what its place and its turn give.
  std::array<double, 4> speedsFor(double thrust, const Eigen::Vector3d& torque) const {
    std::array<double, 4> speeds;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const Quadrotor::Rotor& rotor = drone.rotors[i];
      const double share = thrust +
                           (rotor.y_side * torque.x() - rotor.x_side * torque.y()) / drone.arm -
                           rotor.turn * torque.z() * drone.thrust / drone.drag_torque;
      speeds[i] = std::sqrt(std::max(share / 4, 0.0) / drone.thrust);
    }
    return speeds;
  }
};
