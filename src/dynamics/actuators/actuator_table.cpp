#include "dynamics/actuators/actuator_table.hpp"

#include <algorithm>
#include <utility>

#include "dynamics/actuators/lag.hpp"

namespace rigid_body_sim {
namespace {

using Kind = ActuatorEntry::Kind;

/// From B to P.
struct Axes {
  const Isometry3d& X_BP;
  Vector3d direction(const Vector3d& v_B) const { return X_BP.linear().transpose() * v_B; }
  Vector3d arm(const Vector3d& x_B) const { return direction(x_B - X_BP.translation()); }
};

ActuatorEntry entryOf(const Thruster& thruster, const Axes& axes) {
  ActuatorEntry entry{};
  entry.kind = Kind::kThruster;
  entry.force_P = axes.direction(thruster.direction_B);
  entry.torque_P = axes.arm(thruster.position_B).cross(entry.force_P);
  entry.time_constant = thruster.time_constant;
  return entry;
}

ActuatorEntry entryOf(const Rotor& rotor, const Axes& axes) {
  ActuatorEntry entry{};
  const Vector3d d = axes.direction(rotor.direction_B);
  entry.kind = Kind::kRotor;
  entry.force_P = rotor.thrust * d;
  entry.torque_P =
      axes.arm(rotor.position_B).cross(entry.force_P) - (rotor.turns * rotor.drag_torque) * d;
  entry.momentum_P = (rotor.turns * rotor.inertia) * d;
  entry.inertia = rotor.inertia;
  entry.time_constant = rotor.time_constant;
  entry.speed = rotor.speed;
  return entry;
}

ActuatorEntry entryOf(const Wheel& wheel, const Axes& axes) {
  ActuatorEntry entry{};
  entry.kind = Kind::kWheel;
  entry.momentum_P = axes.direction(wheel.axis_B);
  entry.inertia = wheel.inertia;
  entry.speed = wheel.speed;
  return entry;
}

}  // namespace

double ActuatorEntry::rest() const { return std::min(std::max(0.0, least), greatest); }

ActuatorTable actuatorTable(const Body& body) {
  const Axes axes{body.X_BP};
  ActuatorTable table;
  for (const Actuator& actuator : body.actuators) {
    table.push_back(
        std::visit([&](const auto& kind) { return entryOf(kind, axes); }, actuator.kind));
    table.back().least = actuator.least;
    table.back().greatest = actuator.greatest;
    if (body.pivoted) std::swap(table.back().force_P, table.back().on_pivot_P);
  }
  return table;
}

bool hasSpin(const ActuatorTable& table) {
  return std::any_of(table.begin(), table.end(),
                     [](const ActuatorEntry& entry) { return !entry.momentum_P.isZero(0); });
}

double valueOf(const ActuatorEntry& entry, const ActuatorState& state, double t) {
  if (entry.kind == Kind::kWheel) return state.value + state.command * (t - state.since);
  return laggingValue(state, entry.time_constant, t);
}

std::vector<ActuatorState> startOf(const ActuatorTable& table, const Vector3d& w_P, double t) {
  std::vector<ActuatorState> states;
  for (const ActuatorEntry& entry : table) {
    ActuatorState state;
    state.command = entry.rest();
    state.since = t;
    state.value = entry.speed;
    if (entry.kind == Kind::kWheel)
      state.value = entry.inertia * (entry.speed + entry.momentum_P.dot(w_P));
    states.push_back(state);
  }
  return states;
}

Vector3d momentumOf(const ActuatorTable& table, const std::vector<ActuatorState>& states,
                    double t) {
  Vector3d H_P = Vector3d::Zero();
  for (std::size_t k = 0; k < table.size(); ++k)
    H_P += valueOf(table[k], states[k], t) * table[k].momentum_P;
  return H_P;
}

double energyOf(const ActuatorTable& table, const std::vector<ActuatorState>& states, double t,
                const Vector3d& w_P) {
  double energy = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const ActuatorEntry& entry = table[k];
    if (!(entry.inertia > 0)) continue;
    const double value = valueOf(entry, states[k], t);
    if (entry.kind == Kind::kWheel)
      energy += 0.5 * value * value / entry.inertia;
    else
      energy += value * (0.5 * entry.inertia * value + entry.momentum_P.dot(w_P));
  }
  return energy;
}

}  // namespace rigid_body_sim
