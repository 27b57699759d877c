#include <cmath>
#include <set>

#include <rigid_body_sim/dynamics/actuator.hpp>
#include <rigid_body_sim/dynamics/state.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>

#include "dynamics/actuators/lag.hpp"
#include "dynamics/require.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

ActuatorReading reading(const Thruster& thruster, const ActuatorState& state, double t,
                        const Vector3d&) {
  ActuatorReading now;
  now.force = laggingValue(state, thruster.time_constant, t);
  return now;
}

ActuatorReading reading(const Rotor& rotor, const ActuatorState& state, double t, const Vector3d&) {
  ActuatorReading now;
  now.speed = laggingValue(state, rotor.time_constant, t);
  const double square = now.speed * std::abs(now.speed);
  now.force = rotor.thrust * square;
  now.torque = -rotor.turns * rotor.drag_torque * square;
  return now;
}

ActuatorReading reading(const Wheel& wheel, const ActuatorState& state, double t,
                        const Vector3d& w_B) {
  ActuatorReading now;
  const double h = state.value + state.command * (t - state.since);
  now.speed = h / wheel.inertia - wheel.axis_B.dot(w_B);
  now.torque = state.command;
  return now;
}

bool isDirection(const Vector3d& v) { return v.allFinite() && std::abs(v.norm() - 1) < 1e-9; }

bool isNotNegative(double x) { return x >= 0 && std::isfinite(x); }

bool isTimeConstant(double T) {
  return T == 0 || (T >= kLeastTimeConstant && T <= kGreatestTimeConstant);
}

std::string timeConstantRule() {
  return std::string("time_constant must be 0 or ") + kTimeConstantRange;
}

std::string faultOf(const Thruster& thruster) {
  if (!thruster.position_B.allFinite()) return "position must be finite";
  if (!isDirection(thruster.direction_B)) return "direction must be of unit length";
  if (!isTimeConstant(thruster.time_constant)) return timeConstantRule();
  return "";
}

std::string faultOf(const Rotor& rotor) {
  if (!rotor.position_B.allFinite()) return "position must be finite";
  if (!isDirection(rotor.direction_B)) return "direction must be of unit length";
  if (!isTimeConstant(rotor.time_constant)) return timeConstantRule();
  if (rotor.turns != 1 && rotor.turns != -1) return "turns must be 1 or -1";
  if (!std::isfinite(rotor.thrust) || !std::isfinite(rotor.drag_torque))
    return "thrust and drag_torque must be finite";
  if (!isNotNegative(rotor.inertia)) return "inertia must be >= 0 kg m^2 and finite";
  if (rotor.inertia > 0 && !(rotor.time_constant > 0))
    return "with inertia, time_constant must be > 0 s: else the body's angular velocity would jump";
  if (!std::isfinite(rotor.speed)) return "speed must be finite";
  return "";
}

std::string faultOf(const Wheel& wheel) {
  if (!isDirection(wheel.axis_B)) return "axis must be of unit length";
  if (!(wheel.inertia > 0 && std::isfinite(wheel.inertia)))
    return "inertia must be > 0 kg m^2 and finite";
  if (!std::isfinite(wheel.speed)) return "speed must be finite";
  return "";
}

}  // namespace

ActuatorReading readActuator(const Actuator& actuator, const ActuatorState& state, double t,
                             const Vector3d& w_B) {
  ActuatorReading now =
      std::visit([&](const auto& kind) { return reading(kind, state, t, w_B); }, actuator.kind);
  now.command = state.command;
  now.saturations = state.saturations;
  return now;
}

std::vector<ActuatorReading> readActuators(const Body& body, const State& state,
                                           std::size_t index) {
  require(index < state.bodies.size() && index < state.actuators.size() &&
              state.actuators[index].size() == body.actuators.size(),
          "a state has no actuators of body '", body.name, "' at the index ", index,
          ": take one that a simulation gave");
  const Vector3d w_P = angularVelocity(body.inv_I, state.bodies[index].L_P);
  const Vector3d w_B = body.X_BP.linear() * w_P;
  std::vector<ActuatorReading> readings;
  for (std::size_t k = 0; k < body.actuators.size(); ++k)
    readings.push_back(readActuator(body.actuators[k], state.actuators[index][k], state.t, w_B));
  return readings;
}

Matrix3d withoutWheels(const std::vector<Actuator>& actuators, Matrix3d I_Bcm) {
  for (const Actuator& actuator : actuators)
    if (const auto* wheel = std::get_if<Wheel>(&actuator.kind))
      I_Bcm -= wheel->inertia * wheel->axis_B * wheel->axis_B.transpose();
  return I_Bcm;
}

namespace {

/// What is left of a body's inertia when nothing in it can spin by itself.
Matrix3d withoutSpinning(const std::vector<Actuator>& actuators, const Matrix3d& I_Bcm) {
  Matrix3d I_r = withoutWheels(actuators, I_Bcm);
  for (const Actuator& actuator : actuators)
    if (const auto* rotor = std::get_if<Rotor>(&actuator.kind))
      I_r -= rotor->inertia * rotor->direction_B * rotor->direction_B.transpose();
  return I_r;
}

}  // namespace

std::string actuatorsFault(const std::vector<Actuator>& actuators, const Matrix3d& I_Bcm) {
  std::set<std::string> names;
  for (const Actuator& actuator : actuators) {
    const std::string who = "actuator '" + actuator.name + "': ";
    if (actuator.name.empty() || !names.insert(actuator.name).second)
      return who + "its name must be unique in its body and not empty";
    const std::string fault =
        std::visit([](const auto& kind) { return faultOf(kind); }, actuator.kind);
    if (!fault.empty()) return who + fault;
    if (!(actuator.least <= actuator.greatest))
      return who + "limits must be two numbers that ascend";
    if (std::isinf(actuator.least) && actuator.least == actuator.greatest)
      return who + "limits must not both be infinite alike";
  }
  const double least = principalAxes(withoutSpinning(actuators, I_Bcm)).I(0);
  if (least > 1e-15 * I_Bcm.cwiseAbs().maxCoeff()) return "";
  const std::string rule =
      actuators.empty() ? "its inertia, about the pivot if it has one, must be positive definite "
                          "beyond rounding: one of its moments may be too small for the others"
                        : "its inertia, which includes wheels and rotors, must be positive "
                          "definite without theirs about their axes";
  return rule + ", got a least principal moment of " + shortest(least) + " kg m^2";
}

}  // namespace rigid_body_sim
