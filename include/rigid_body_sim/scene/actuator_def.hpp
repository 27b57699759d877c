#pragma once

#include <limits>
#include <string>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// The actuators of a body as a scene describes them, in its body frame. `line` is where an entry
/// stands in the file, 0 in a scene made by a program.

/// What a command is held between: lowest <= highest; infinite: no limit.
struct LimitsDef {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// A force along an axis of the body; the command is the force.
struct ThrusterDef {
  std::string name;
  Vector3d position = Vector3d::Zero();    ///< [m] where the force acts
  Vector3d direction = Vector3d::UnitZ();  ///< unit
  LimitsDef limits;                        ///< [N]
  double time_constant = 0;                ///< [s] of the lag; 0: none
  int line = 0;
};

/// A propeller; the command is its speed relative to the body.
struct RotorDef {
  std::string name;
  Vector3d position = Vector3d::Zero();    ///< [m] where the thrust acts
  Vector3d direction = Vector3d::UnitZ();  ///< unit, of the thrust
  bool clockwise = false;                  ///< turns negatively about the direction
  double thrust = 0;                       ///< [N s²] >= 0, over speed squared
  double drag_torque = 0;                  ///< [N m s²] >= 0, likewise
  double inertia = 0;        ///< [kg m²] >= 0, about the direction; needs a time constant
  LimitsDef limits;          ///< [rad/s]
  double time_constant = 0;  ///< [s] of the lag; 0: none
  double speed = 0;          ///< [rad/s] at the start; needs a time constant
  int line = 0;
};

/// A reaction wheel; the command is the torque of its motor.
struct WheelDef {
  std::string name;
  Vector3d axis = Vector3d::UnitZ();  ///< unit
  double inertia = 0;                 ///< [kg m²] > 0, about the axis
  LimitsDef limits;                   ///< [N m]
  double speed = 0;                   ///< [rad/s] relative to the body, at the start
  int line = 0;
};

struct ActuatorDefs {
  std::vector<ThrusterDef> thrusters;
  std::vector<RotorDef> rotors;
  std::vector<WheelDef> wheels;

  bool any() const { return !thrusters.empty() || !rotors.empty() || !wheels.empty(); }
};

/// A command that the scene gives, held until the next one to the same actuator.
struct CommandDef {
  std::string body;
  std::string actuator;
  double value = 0;  ///< [N], [rad/s] or [N m]: of a thruster, rotor or wheel
  double start = 0;  ///< [s] since the start of the simulation
  int line = 0;
};

}  // namespace rigid_body_sim
