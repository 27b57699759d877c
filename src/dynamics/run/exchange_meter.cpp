#include "dynamics/run/exchange_meter.hpp"

#include <utility>

#include "dynamics/step_too_long.hpp"
#include "math/gauss_legendre.hpp"

namespace rigid_body_sim {

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
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyState& s = bodies[i];
    const Wrench& all = workspace_.wrenches[i];
    const Vector3d x_W = s.x_W + s.x_low_W;
    sum_.momentum += weight * all.f_W;
    sum_.angular_momentum += weight * (x_W.cross(all.f_W) + all.tau_W + rotate(s.q_WP, all.tau_P));
  }
}

Totals ExchangeMeter::take() { return std::exchange(sum_, Totals()); }

}  // namespace rigid_body_sim
