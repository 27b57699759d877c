#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// An actuator as the equations of motion know it, in principal axes: with x = e, Ω|Ω| or 0 it adds
/// the force x force_P and the torque x torque_P, with y = 0, Ω or h the momentum y momentum_P.
struct ActuatorEntry {
  enum class Kind { kThruster, kRotor, kWheel };
  Kind kind;
  Vector3d force_P = Vector3d::Zero();     ///< thruster: d;  rotor: thrust d
  Vector3d torque_P = Vector3d::Zero();    ///< about the origin of P, of what is outside the body
  Vector3d on_pivot_P = Vector3d::Zero();  ///< of a body on a pivot, in place of force_P
  Vector3d momentum_P = Vector3d::Zero();  ///< rotor: J s d;  wheel: a
  double inertia = 0;                      ///< [kg m²]
  double time_constant = 0;                ///< [s]
  double speed = 0;                        ///< [rad/s] at the start
  double least, greatest;                  ///< limits of the command

  /// The command within the limits nearest to 0.
  double rest() const;
};

/// The actuators of a body, in the order of Body::actuators.
using ActuatorTable = std::vector<ActuatorEntry>;

ActuatorTable actuatorTable(const Body& body);

/// Whether any of them carries angular momentum.
bool hasSpin(const ActuatorTable& table);

/// The value of a thruster, rotor or wheel at t [s] >= state.since.
double valueOf(const ActuatorEntry& entry, const ActuatorState& state, double t);

/// As they start at time t, the body turning at w_P [rad/s].
std::vector<ActuatorState> startOf(const ActuatorTable& table, const Vector3d& w_P, double t);

/// H [kg m²/s] in principal axes.
Vector3d momentumOf(const ActuatorTable& table, const std::vector<ActuatorState>& states, double t);

/// What rotors and wheels have beyond ½ ω·I ω:  Σ h²/2J + Σ (½ J Ω² + J s Ω d·ω)  [J]
double energyOf(const ActuatorTable& table, const std::vector<ActuatorState>& states, double t,
                const Vector3d& w_P);

}  // namespace rigid_body_sim
