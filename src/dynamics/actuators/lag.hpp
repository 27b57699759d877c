#pragma once

#include <cmath>

#include <rigid_body_sim/dynamics/actuator.hpp>

namespace rigid_body_sim {

/// The value at t [s] >= state.since of what follows its command by  v' = (u − v)/T:
///   v = v₀ + (v₀ − u) expm1(−(t − since)/T),  and u where T is zero.
inline double laggingValue(const ActuatorState& state, double time_constant, double t) {
  if (!(time_constant > 0)) return state.command;
  return state.value +
         (state.value - state.command) * std::expm1((state.since - t) / time_constant);
}

/// I − Σ J a aᵀ [kg m²]: the inertia without what the wheels have about their own axes.
Matrix3d withoutWheels(const std::vector<Actuator>& actuators, Matrix3d I_Bcm);

}  // namespace rigid_body_sim
