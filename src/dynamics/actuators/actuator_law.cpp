#include "dynamics/actuators/actuator_law.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {
namespace {

using Kind = ActuatorEntry::Kind;

/// v' of what lags.
double rateOf(const ActuatorEntry& entry, const ActuatorState& state, double value) {
  return entry.time_constant > 0 ? (state.command - value) / entry.time_constant : 0;
}

}  // namespace

unsigned needsOf(const ActuatorTable& table) { return hasSpin(table) ? kThrust | kSpin : kThrust; }

ActuatorLaw::ActuatorLaw(std::size_t body, const ActuatorSchedule& schedule)
    : body_(body),
      table_(schedule.sharedTable()),
      states_(schedule.states()),
      drive_(driveOf(*table_, states_)) {}

std::shared_ptr<const ForceLaw> ActuatorLaw::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto law = std::make_shared<ActuatorLaw>(*this);
  law->body_ = index(body_);
  return law;
}

Vector3d ActuatorLaw::angularVelocityOf(const Bodies& at) const {
  return angularVelocity(at.bodies[body_]->inv_I, at.states[body_].L_P);
}

void ActuatorLaw::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const ActuatorDrive::Value now = drive_.at(at.own[0]);
  Wrench& wrench = wrenches[body_];
  wrench.f_W += rotate(at.states[body_].q_WP, now.f_P);
  wrench.tau_P += now.tau_P + (now.H_P.cross(angularVelocityOf(at)) - now.H_dot_P);
}

Vector3d ActuatorLaw::reactionOn(const Bodies& at) const {
  const ActuatorDrive::Value now = drive_.at(at.own[0]);
  return now.H_P.cross(angularVelocityOf(at)) - now.H_dot_P;
}

Vector3d ActuatorLaw::onPivot(const Bodies& at) const {
  Vector3d sum_P = Vector3d::Zero();
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const ActuatorEntry& entry = (*table_)[k];
    const double value = valueOf(entry, states_[k], drive_.start + at.own[0]);
    sum_P += (entry.kind == Kind::kRotor ? value * std::abs(value) : value) * entry.on_pivot_P;
  }
  return sum_P;
}

double ActuatorLaw::potentialEnergy(const Bodies& at) const {
  return energyOf(*table_, states_, drive_.start + at.own[0], Vector3d::Zero());
}

double ActuatorLaw::externalPower(const Bodies& at) const {
  const ActuatorDrive::Value now = drive_.at(at.own[0]);
  const BodyState& s = at.states[body_];
  const double t = drive_.start + at.own[0];
  double power = rotate(s.q_WP, now.f_P).dot(s.p_W) / at.bodies[body_]->mass +
                 (now.tau_P - now.H_dot_P).dot(angularVelocityOf(at));
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const ActuatorEntry& entry = (*table_)[k];
    if (!(entry.inertia > 0)) continue;
    const double value = valueOf(entry, states_[k], t);
    power += entry.kind == Kind::kWheel ? value / entry.inertia * states_[k].command
                                        : entry.inertia * value * rateOf(entry, states_[k], value);
  }
  return power;
}

double ActuatorLaw::couplingPower(const Bodies& at, const Vector3d& w_dot_P) const {
  const double t = drive_.start + at.own[0];
  const Vector3d w_P = angularVelocityOf(at);
  double power = 0;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const ActuatorEntry& entry = (*table_)[k];
    if (entry.kind != Kind::kRotor || !(entry.inertia > 0)) continue;
    const double value = valueOf(entry, states_[k], t);
    power += entry.momentum_P.dot(rateOf(entry, states_[k], value) * w_P + value * w_dot_P);
  }
  return power;
}

void ActuatorLaw::setRates(const Bodies&, double* rates) const { rates[0] = 1; }

/// Of lags while they last, of the precession about the momentum of wheels and rotors, and of what
/// the torque brings about.
double ActuatorLaw::rate(const Bodies& at, const std::vector<double>&) const {
  const Vector3d& inv_I = at.bodies[body_]->inv_I;
  const ActuatorDrive::Value now = drive_.at(at.own[0]);
  double fastest = std::max(inv_I.cwiseProduct(now.H_P).norm(),
                            std::sqrt(inv_I.cwiseProduct(now.tau_P - now.H_dot_P).norm()));
  for (const ActuatorDrive::Lag& lag : drive_.lags) fastest = std::max(fastest, 2 * lag.rate);
  return fastest;
}

}  // namespace rigid_body_sim
