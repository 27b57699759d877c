#include "support/motor_benches.hpp"

#include <algorithm>

namespace rigid_body_sim::test {

Actuator named(const std::string& name, const std::variant<Thruster, Rotor, Wheel>& kind,
               double limit) {
  return {name, kind, -limit, limit};
}

Rotor rotorAt(const Vector3d& position, int turns, double inertia) {
  Rotor rotor;
  rotor.position_B = position;
  rotor.turns = turns;
  rotor.thrust = 8.5e-6;
  rotor.drag_torque = 1.4e-7;
  rotor.inertia = inertia;
  rotor.time_constant = 0.03;
  return rotor;
}

Wheel wheelAlong(const Vector3d& axis, double inertia, double speed) {
  return {axis.normalized(), inertia, speed};
}

Thruster thrusterAt(const Vector3d& position, const Vector3d& direction, double T) {
  return {position, direction.normalized(), T};
}

reference::MotorBody quadrotor() {
  reference::MotorBody body;
  body.properties_B = {1.2, Vector3d::Zero(), Vector3d(10e-3, 12.5e-3, 19.5e-3).asDiagonal()};
  body.actuators = {named("front_left", rotorAt({0.2, 0.2, 0}, 1), 1100),
                    named("rear_left", rotorAt({-0.2, 0.2, 0}, -1), 1100),
                    named("rear_right", rotorAt({-0.2, -0.2, 0}, 1), 1100),
                    named("front_right", rotorAt({0.2, -0.2, 0}, -1), 1100)};
  body.g_W = {0, 0, -9.81};
  return body;
}

reference::MotorBody motley() {
  reference::MotorBody body;
  Matrix3d I;
  I << 0.9, 0.05, -0.1, 0.05, 1.4, 0.08, -0.1, 0.08, 1.1;
  body.properties_B = {3, {0.05, -0.02, 0.1}, I};
  Rotor rotor = rotorAt({0.3, 0.1, -0.2}, -1, 0.02);
  rotor.direction_B = Vector3d(0.2, -0.3, 1).normalized();
  rotor.thrust = 3e-3;
  rotor.drag_torque = 4e-4;
  rotor.time_constant = 0.2;
  rotor.speed = 15;
  body.actuators = {named("main", thrusterAt({0.1, 0.2, -0.4}, {1, 0.3, 2}, 0.15)),
                    named("propeller", rotor), named("wheel", wheelAlong({1, 2, -0.5}, 0.12, 8)),
                    named("small", wheelAlong({-1, 0.3, 0.4}, 0.05, -20))};
  body.g_W = {0.3, 0, -9.81};
  return body;
}

BodyFrameMotion motleyStart() {
  BodyFrameMotion motion;
  motion.x_W = {1, -2, 0.5};
  motion.q_WB = Quaterniond(0.8, 0.1, -0.5, 0.3).normalized();
  motion.v_W = {0.4, 1, -0.3};
  motion.w_W = {0.6, -1.1, 0.9};
  return motion;
}

Bench benchOf(const reference::MotorBody& motors, const BodyFrameMotion& start) {
  Bench bench;
  bench.world.g_W = motors.g_W;
  bench.add(makeBody("body", motors.properties_B, motors.actuators), start);
  return bench;
}

ActuatorCommand commandOf(std::size_t actuator, double value, double start) {
  ActuatorCommand command;
  command.actuator = actuator;
  command.value = value;
  command.start = start;
  return command;
}

double relativeGap(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm() / std::max(1.0, b.norm());
}

}  // namespace rigid_body_sim::test
