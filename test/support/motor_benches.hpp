#pragma once

#include <limits>
#include <string>
#include <variant>

#include "support/reference_motors.hpp"
#include "support/worlds.hpp"

/// Bodies with motors that the tests share.
namespace rigid_body_sim::test {

Actuator named(const std::string& name, const std::variant<Thruster, Rotor, Wheel>& kind,
               double limit = std::numeric_limits<double>::infinity());

Rotor rotorAt(const Vector3d& position, int turns, double inertia = 6e-5);

Wheel wheelAlong(const Vector3d& axis, double inertia, double speed = 0);

Thruster thrusterAt(const Vector3d& position, const Vector3d& direction, double T);

/// The quadrotor of numerics: 1.2 kg, four rotors that lag by 0.03 s.
reference::MotorBody quadrotor();

/// A lopsided body with motors of every kind, none of them along an axis of symmetry.
reference::MotorBody motley();

BodyFrameMotion motleyStart();

/// The same body in a world of the product.
Bench benchOf(const reference::MotorBody& motors, const BodyFrameMotion& start);

ActuatorCommand commandOf(std::size_t actuator, double value, double start);

double relativeGap(const Vector3d& a, const Vector3d& b);

}  // namespace rigid_body_sim::test
