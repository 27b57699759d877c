#include "dynamics/run/exchange_meter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/gauss_legendre.hpp"

namespace rigid_body_sim {
namespace {

/// Nodes that integrate to rounding over a share of the time that a solution holds for. A free
/// flight, which holds for ever, brings integrands quadratic in time at most: two nodes. A Taylor
/// series of degree N to rounding ε holds for at most ε^(1/N) = 1/6 of its radius of convergence
/// (N = 20). Where the integrand is analytic up to there, the rule's error falls by
/// r² >= (22/share)² a node: r is the sum of the half axes of the ellipse with foci at both ends
/// that reaches the nearest singularity. Series to a looser tolerance reach further; there the rule
/// errs by less than they do. Source: Trefethen, SIAM Review 50 (2008) 67, theorem 4.5.
int nodesFor(double share) {
  constexpr double kDigits = 18;
  const double digits_a_node = 2 * std::log10(22 / std::max(share, 1e-12));
  return std::clamp(static_cast<int>(std::ceil(kDigits / digits_a_node)), 2, kMostGaussNodes);
}

}  // namespace

void ExchangeMeter::step(const Method& method, const System& system, double h,
                         const std::vector<BodyState>& start) {
  if (method.claimsTo(kSolves)) return solve(system, h, start[0]);
  try {
    for (const QuadratureNode& node : gaussLegendre(method.order / 2 + 1)) {
      states_ = start;
      workspace_.wrenches_current = false;
      method.step(system, node.place * h, states_, workspace_);
      add(node.weight * h, system);
    }
  } catch (const StepTooLong&) {
    sum_ = Totals::unknown();
  }
}

/// A step that spans any number of series of one body.
void ExchangeMeter::solve(const System& system, double h, const BodyState& start) {
  constexpr int kMostSegments = 1000000;  // as in advanceTaylor
  BodyState state = start;
  double t = 0;
  for (int segments = 0; t < h; ++segments) {
    const SolvedMotion motion(*system.bodies[0], system.held[0], system.g_W, t, state, h - t, {});
    const double t_end = std::min(h, motion.validUntil());
    if (!(t_end > t) || segments == kMostSegments) {
      sum_ = Totals::unknown();
      return;
    }
    solved(system, motion, t, t_end);
    state = motion.at(t_end);
    t = t_end;
  }
}

void ExchangeMeter::solved(const System& system, const SolvedMotion& motion, double t,
                           double t_end) {
  const double h = t_end - t;
  states_.resize(1);
  for (const QuadratureNode& node : gaussLegendre(nodesFor(h / (motion.validUntil() - t)))) {
    states_[0] = motion.at(t + node.place * h);
    add(node.weight * h, system);
  }
}

/// weight times the rates of exchange at the present states.
void ExchangeMeter::add(double weight, const System& system) {
  evaluateAppliedAndDrag(system, states_, workspace_);
  double power = 0;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const BodyState& s = states_[i];
    const Wrench& applied = workspace_.wrenches[i];
    const Vector3d w_P = angularVelocity(system.bodies[i]->inv_I, s.L_P);
    power += applied.f_W.dot(s.p_W) / system.bodies[i]->mass +
             w_P.dot(rotateBack(s.q_WP, applied.tau_W) + applied.tau_P);
  }
  for (const auto& law : system.laws) power += law->externalPower({system.bodies, states_});
  sum_.energy += weight * power;

  evaluateWrenchesAndDrag(system, states_, workspace_);
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const BodyState& s = states_[i];
    const Wrench& all = workspace_.wrenches[i];
    const Vector3d x_W = s.x_W + s.x_low_W;
    sum_.momentum += weight * all.f_W;
    sum_.angular_momentum += weight * (x_W.cross(all.f_W) + all.tau_W + rotate(s.q_WP, all.tau_P));
  }
}

Totals ExchangeMeter::take() { return std::exchange(sum_, Totals()); }

}  // namespace rigid_body_sim
