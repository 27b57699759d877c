#include "dynamics/run/exchange_meter.hpp"

#include <utility>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/step_too_long.hpp"
#include "math/gauss_legendre.hpp"

namespace rigid_body_sim {
namespace {

double potentialOfLaws(const System& system, const SystemState& states) {
  double energy = 0;
  for (const auto& law : system.laws)
    energy += law->potentialEnergy({system.bodies, states.bodies});
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    if (law.acts(at.own)) energy += law.potentialEnergy(at);
  });
  return energy;
}

}  // namespace

void ExchangeMeter::operator()(const MotionPiece& piece) {
  const double h = piece.end() - piece.start();
  try {
    for (const QuadratureNode& node : gaussLegendre(piece.gaussNodes())) {
      piece.at(piece.start() + node.place * h, states_);
      add(node.weight * h, piece.system());
    }
  } catch (const StepTooLong&) {
    sum_ = Totals::unknown();
  }
}

/// weight times the rates of exchange at the present states.
void ExchangeMeter::add(double weight, const System& system) {
  const std::vector<BodyState>& bodies = states_.bodies;
  evaluateAppliedAndFlows(system, states_, workspace_);
  double power = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyState& s = bodies[i];
    const Wrench& applied = workspace_.wrenches[i];
    const Vector3d w_P = angularVelocity(system.bodies[i]->inv_I, s.L_P);
    power += applied.f_W.dot(s.p_W) / system.bodies[i]->mass +
             w_P.dot(rotateBack(s.q_WP, applied.tau_W) + applied.tau_P);
  }
  power += externalPower(system, states_);
  sum_.energy += weight * power;

  evaluateAllWrenches(system, states_, workspace_);
  for (const System::Pivot& pivot : system.pivots) addPivot(weight, pivot, system);
  for (const System::Driven& driven : system.driven) addMotors(weight, driven, system);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyState& s = bodies[i];
    const Wrench& all = workspace_.wrenches[i];
    const Vector3d x_W = s.x_W + s.x_low_W;
    sum_.momentum += weight * all.f_W;
    sum_.angular_momentum += weight * (x_W.cross(all.f_W) + all.tau_W + rotate(s.q_WP, all.tau_P));
  }
}

void ExchangeMeter::addChange(const System& system, const SystemState& before,
                              const SystemState& after) {
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const Body& body = *system.bodies[i];
    const BodyState &a = before.bodies[i], &b = after.bodies[i];
    const Vector3d a_W = a.x_W + a.x_low_W, b_W = b.x_W + b.x_low_W;
    const Vector3d moved_W = (b.x_W - a.x_W) + (b.x_low_W - a.x_low_W);
    sum_.energy +=
        kineticEnergy(body, b) - kineticEnergy(body, a) - body.mass * system.g_W.dot(moved_W);
    sum_.momentum += b.p_W - a.p_W;
    sum_.angular_momentum += (b.L_W + b_W.cross(b.p_W)) - (a.L_W + a_W.cross(a.p_W));
  }
  sum_.energy += potentialOfLaws(system, after) - potentialOfLaws(system, before);
}

/// All forces on a body on a pivot together are m a_c. What is held includes the torque of gravity,
/// whose work the potential accounts for.
void ExchangeMeter::addPivot(double weight, const System::Pivot& pivot, const System& system) {
  const Body& body = *system.bodies[pivot.body];
  const BodyState& s = states_.bodies[pivot.body];
  BodyMotion motion{s, {}};
  const Vector3d L_dot_P = stateDot(body, s, workspace_.wrenches[pivot.body]).L_dot_P;
  motion.acceleration.w_dot_P = angularVelocity(body.inv_I, L_dot_P);
  workspace_.wrenches[pivot.body].f_W = body.mass * accelerationOf(body, motion, body.com_P);
  sum_.energy -= weight * pivot.g_W.dot(momentumOf(body, s));
}

/// What the law of motors leaves out; its reactions change no angular momentum.
void ExchangeMeter::addMotors(double weight, const System::Driven& driven, const System& system) {
  const ForceLaw::Bodies at{system.bodies, states_.bodies, &states_.laws[driven.state]};
  const Body& body = *system.bodies[driven.body];
  Wrench& wrench = workspace_.wrenches[driven.body];
  const Vector3d L_dot_P = stateDot(body, states_.bodies[driven.body], wrench).L_dot_P;
  sum_.energy += weight * driven.law->couplingPower(at, angularVelocity(body.inv_I, L_dot_P));
  wrench.tau_P -= driven.law->reactionOn(at);
}

Totals ExchangeMeter::take() { return std::exchange(sum_, Totals()); }

}  // namespace rigid_body_sim
