#include "dynamics/actuators/actuator_drive.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigid_body_sim {
namespace {

ActuatorDrive::Lag& lagOf(double rate, std::vector<ActuatorDrive::Lag>& lags) {
  for (ActuatorDrive::Lag& lag : lags)
    if (lag.rate == rate) return lag;
  lags.push_back({rate});
  return lags.back();
}

/// Adds an actuator by its x and y (see ActuatorEntry), as polynomials of an ε that its lag lets
/// die away:  x = x[0] + x[1] ε + x[2] ε²,  y = y[0] + y[1] ε
void addLagging(const ActuatorEntry& entry, const std::array<double, 3>& x,
                const std::array<double, 2>& y, ActuatorDrive& drive) {
  drive.f_0 += x[0] * entry.force_P;
  drive.tau_0 += x[0] * entry.torque_P;
  drive.H_0 += y[0] * entry.momentum_P;
  if (x[1] == 0 && x[2] == 0 && y[1] == 0) return;
  ActuatorDrive::Lag& lag = lagOf(1 / entry.time_constant, drive.lags);
  lag.f_1 += x[1] * entry.force_P;
  lag.tau_1 += x[1] * entry.torque_P;
  lag.f_2 += x[2] * entry.force_P;
  lag.tau_2 += x[2] * entry.torque_P;
  lag.H_2 += y[1] * entry.momentum_P;
}

}  // namespace

ActuatorDrive driveOf(const ActuatorTable& table, const std::vector<ActuatorState>& states) {
  ActuatorDrive drive;
  drive.start = states.front().since;
  for (const ActuatorState& state : states) drive.start = std::max(drive.start, state.since);
  for (std::size_t k = 0; k < table.size(); ++k) {
    const ActuatorEntry& entry = table[k];
    const ActuatorState& state = states[k];
    const double value = valueOf(entry, state, drive.start), u = state.command;
    const double delta = value - u;
    if (entry.kind == ActuatorEntry::Kind::kWheel) {
      drive.H_0 += value * entry.momentum_P;
      drive.H_1 += u * entry.momentum_P;
    } else if (entry.kind == ActuatorEntry::Kind::kThruster) {
      addLagging(entry, {u, delta, 0}, {0, 0}, drive);
    } else {
      // by the value at which it set out: one that is about to pass zero may have rounded beyond
      const double sign = std::copysign(1.0, state.value != 0 ? state.value : u);
      addLagging(entry, {sign * u * u, sign * 2 * u * delta, sign * delta * delta}, {u, delta},
                 drive);
    }
  }
  return drive;
}

ActuatorDrive::Value ActuatorDrive::at(double dt) const {
  Value now{f_0, tau_0, H_0 + dt * H_1, H_1};
  for (const Lag& lag : lags) {
    const double e = std::exp(-lag.rate * dt), ee = e * e;
    now.f_P += e * lag.f_1 + ee * lag.f_2;
    now.tau_P += e * lag.tau_1 + ee * lag.tau_2;
    now.H_P += e * lag.H_2;
    now.H_dot_P -= (e * lag.rate) * lag.H_2;
  }
  return now;
}

bool ActuatorDrive::isIdle() const {
  return !turns() && !spins() && f_0.isZero(0) &&
         std::all_of(lags.begin(), lags.end(),
                     [](const Lag& lag) { return lag.f_1.isZero(0) && lag.f_2.isZero(0); });
}

bool ActuatorDrive::turns() const {
  return !tau_0.isZero(0) || std::any_of(lags.begin(), lags.end(), [](const Lag& lag) {
    return !lag.tau_1.isZero(0) || !lag.tau_2.isZero(0);
  });
}

bool ActuatorDrive::spins() const {
  return !H_0.isZero(0) || !H_1.isZero(0) ||
         std::any_of(lags.begin(), lags.end(), [](const Lag& lag) { return !lag.H_2.isZero(0); });
}

double ActuatorDrive::forceBound() const {
  double bound = f_0.norm();
  for (const Lag& lag : lags) bound += lag.f_1.norm() + lag.f_2.norm();
  return bound;
}

double ActuatorDrive::torqueBound() const {
  double bound = tau_0.norm() + H_1.norm();
  for (const Lag& lag : lags)
    bound += lag.tau_1.norm() + lag.tau_2.norm() + lag.rate * lag.H_2.norm();
  return bound;
}

}  // namespace rigid_body_sim
