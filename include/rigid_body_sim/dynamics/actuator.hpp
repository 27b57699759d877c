#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

/// Motors of a body: thrusters, rotors and wheels. Their lag, their thrust and their angular
/// momentum belong to the equations of motion; see doc/motors.md. Places and directions are given
/// in the body frame B, in which they never change.
namespace rigid_body_sim {

/// [s] Of the lag of an actuator that has one: beyond, exponentials overflow or die away within a
/// rounding of the time.
constexpr double kLeastTimeConstant = 1e-9, kGreatestTimeConstant = 1e9;
constexpr const char* kTimeConstantRange = "from 1e-9 to 1e9 s";

/// A force e along `direction`:  e' = (u − e)/T, or e = u where there is no time constant. The
/// command u is in N. It starts at e = 0.
struct Thruster {
  Vector3d position_B = Vector3d::Zero();    ///< [m] where the force acts
  Vector3d direction_B = Vector3d::UnitZ();  ///< unit
  double time_constant = 0;                  ///< [s] T: 0, or 1e-9 to 1e9
};

/// A propeller that turns at the speed Ω relative to the body. With s = turns and d = direction:
///   Ω' = (u − Ω)/T, or Ω = u where there is no time constant; the command u is in rad/s
///   force  thrust Ω|Ω| d at the position,  torque of the air  −s drag_torque Ω|Ω| d
///   angular momentum  inertia s Ω d
/// The motor's reaction follows from the angular momentum.
struct Rotor {
  Vector3d position_B = Vector3d::Zero();    ///< [m] where the thrust acts
  Vector3d direction_B = Vector3d::UnitZ();  ///< unit
  int turns = 1;                             ///< s: 1 ccw, a positive turn about d; −1 cw
  double thrust = 0;                         ///< [N s²]
  double drag_torque = 0;                    ///< [N m s²]
  double inertia = 0;        ///< [kg m²] J >= 0 about d; above zero only with T > 0
  double time_constant = 0;  ///< [s] T: 0, or 1e-9 to 1e9
  double speed = 0;          ///< [rad/s] Ω at the start
};

/// A wheel with the angular momentum h along its axis, seen from inertial space: h' = u. The
/// command u is the motor's torque on the wheel in N m; −u acts on the body. Its speed relative to
/// the body is h/J − a·ω.
struct Wheel {
  Vector3d axis_B = Vector3d::UnitZ();  ///< a, unit
  double inertia = 0;                   ///< [kg m²] J > 0 about the axis
  double speed = 0;                     ///< [rad/s] at the start, relative to the body
};

struct Actuator {
  std::string name;  ///< unique within the body
  std::variant<Thruster, Rotor, Wheel> kind;
  /// Limits of the command; a command beyond them is held at the limit, and counted.
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// A command to an actuator, in its unit. It is in effect for start <= t < end unless a later one
/// takes over; after the end, and before the first command, the value within the limits nearest to
/// 0 is. Of two that start together, the one given later counts.
struct ActuatorCommand {
  std::size_t body = 0;      ///< index
  std::size_t actuator = 0;  ///< index in Body::actuators
  double value = 0;          ///< thruster: [N], rotor: [rad/s], wheel: [N m]
  double start = 0;          ///< [s]
  double end = std::numeric_limits<double>::infinity();  ///< [s] of a timeout, for instance
};

/// What changes about an actuator. From `since` on its motion is known in closed form, until the
/// command changes: of a thruster the force e [N], of a rotor the speed Ω [rad/s], of a wheel the
/// angular momentum h [kg m²/s].
struct ActuatorState {
  double command = 0;                                      ///< u in effect, within the limits
  double value = 0;                                        ///< e, Ω or h at the time `since`
  double since = 0;                                        ///< [s]
  double until = std::numeric_limits<double>::infinity();  ///< [s] end of the command
  std::int64_t saturations = 0;  ///< commands so far that were beyond the limits
};

/// What an actuator does at an instant.
struct ActuatorReading {
  double command = 0;  ///< u in effect, within the limits
  double speed = 0;    ///< [rad/s] of a rotor or wheel relative to the body
  double force = 0;    ///< [N] of a thruster or rotor along its direction
  double torque = 0;   ///< [N m] of a wheel: its motor's on the wheel; of a rotor: the air's on the
                       ///< body, about its direction
  std::int64_t saturations = 0;  ///< commands so far that were beyond the limits
};

/// What an actuator does at a time t >= state.since; w_B [rad/s]: the body's angular velocity then,
/// in its own axes.
ActuatorReading readActuator(const Actuator& actuator, const ActuatorState& state, double t,
                             const Vector3d& w_B);

/// Says which rule the actuators of a body break, naming the actuator; empty when none: numbers
/// finite, directions of unit length, least <= greatest and not both infinite alike, time constants
/// within their range, inertia of wheels > 0 and of rotors >= 0, a rotor with inertia has a time
/// constant, names unique and not empty. I_Bcm [kg m²]: of the body with all wheels and rotors, as
/// if they stood still in it. Without what these have about their axes, I − Σ J a aᵀ, its least
/// moment must exceed 1e-15 of its greatest entry.
std::string actuatorsFault(const std::vector<Actuator>& actuators, const Matrix3d& I_Bcm);

}  // namespace rigid_body_sim
