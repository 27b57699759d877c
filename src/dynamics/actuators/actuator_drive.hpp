#pragma once

#include <vector>

#include "dynamics/actuators/actuator_table.hpp"

namespace rigid_body_sim {

/// What the actuators of a body add to its equations of motion from an instant on until the next
/// event, summed up: however many there are, evaluation costs the same. With εⱼ = exp(−rateⱼ t), t
/// from the instant on, in principal axes:
///   force     f = f_0 + Σⱼ (f_1 ε + f_2 ε²),   torque τ likewise
///   momentum  H = H_0 + H_1 t + Σⱼ H_2 ε
/// A speed that lags is Ω = u + δ ε, and Ω|Ω| = σ (u² + 2 u δ ε + δ² ε²) as long as it keeps its
/// sign σ.
struct ActuatorDrive {
  struct Lag {
    double rate;  ///< [1/s] 1/T
    Vector3d f_1 = Vector3d::Zero(), f_2 = Vector3d::Zero();
    Vector3d tau_1 = Vector3d::Zero(), tau_2 = Vector3d::Zero();
    Vector3d H_2 = Vector3d::Zero();
  };
  /// At an instant.
  struct Value {
    Vector3d f_P = Vector3d::Zero();      ///< [N]
    Vector3d tau_P = Vector3d::Zero();    ///< [N m] about the centre of mass, from outside
    Vector3d H_P = Vector3d::Zero();      ///< [kg m²/s]
    Vector3d H_dot_P = Vector3d::Zero();  ///< [N m]
  };

  double start = 0;  ///< [s] the instant
  Vector3d f_0 = Vector3d::Zero(), tau_0 = Vector3d::Zero();
  Vector3d H_0 = Vector3d::Zero(), H_1 = Vector3d::Zero();
  std::vector<Lag> lags;  ///< one for each rate

  /// dt [s] after the instant.
  Value at(double dt) const;

  /// Whether nothing acts, now and until the next event.
  bool isIdle() const;

  /// Whether the torque may be other than zero; whether the momentum may.
  bool turns() const;
  bool spins() const;

  /// Bounds on force [N] and torque [N m, reactions included] until `duration` [s] after the start.
  double forceBound() const;
  double torqueBound() const;
};

/// The sum from the instant on at which the last of the actuators was commanded, or changed its
/// course otherwise.
ActuatorDrive driveOf(const ActuatorTable& table, const std::vector<ActuatorState>& states);

}  // namespace rigid_body_sim
