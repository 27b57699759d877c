#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/methods/dop853_coefficients.hpp"

namespace rigid_body_sim {
namespace {

using dop853::kStages;
using Weights = std::array<double, kStages>;

/// Σ weights[s] dots[n s] over stages. A fourth of the weights are zeros, which add nothing.
BodyStateDot weighted(const Weights& weights, std::size_t stages, const BodyStateDot* dots,
                      std::size_t n) {
  BodyStateDot sum;
  for (std::size_t s = 0; s < stages; ++s)
    if (weights[s] != 0) accumulate(dots[s * n], weights[s], sum);
  return BodyStateDot(sum);  // a copy, so that the sum is kept in registers
}

/// x^(9/4)
double power9_4(double x) { return x * x * std::sqrt(std::sqrt(x)); }

/// What a step got wrong by its embedded estimates, the greatest of all bodies: attitude [rad],
/// angular momentum and momentum relative to their size and change, each by itself, so that a fast
/// flight does not hide a bad attitude. Where a body has come to rest on a stiff spring, momenta
/// are rounding and their relative errors mean nothing: see StepBound::idle. The estimate of order
/// 5 vanishes by accident now and then, as its sign changes, and that of order 8 with it; that of
/// order 3 tells: see StepBound::least_share.
template <bool kHasLeast>
double errorEstimate(const System& system, double h, const std::vector<BodyState>& states,
                     const std::vector<BodyStateDot>& dots, const StepBound& bound) {
  const std::size_t n = states.size();
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const BodyStateDot error5 = weighted(dop853::kE5, kStages, &dots[i], n);
    BodyStateDot error3 = weighted(dop853::kB, kStages, &dots[i], n);
    accumulate(dots[0 * n + i], -dop853::kB3_0, error3);
    accumulate(dots[8 * n + i], -dop853::kB3_8, error3);
    accumulate(dots[11 * n + i], -dop853::kB3_11, error3);
    // least: what does not count
    const auto consider = [&](double e5, double e3, double least, double scale) {
      const double size = std::hypot(e5, 0.1 * e3);
      double e = size > 0 ? h * e5 * (e5 / size) : 0.0;
      if constexpr (kHasLeast) {
        // what lies beyond all numbers is not known to be small
        if (!std::isfinite(size)) e = std::numeric_limits<double>::infinity();
        if (scale > 0) e = std::max(e, bound.least_share * scale * power9_4(h * e3 / scale));
        // counted to reach the bound where it reaches `least`, or the bound relative to the size
        worst = std::max(worst, e > 0 ? e / std::max(scale, least / bound.error) : 0.0);
      } else {
        worst = std::max(worst, e <= least ? 0.0 : e / scale);
      }
    };
    const Body& body = *system.bodies[i];
    const double least_L = bound.idle * body.I.minCoeff() / h;
    const double least_p = bound.idle * std::sqrt(body.I.maxCoeff() / body.mass) * body.mass / h;
    const double L = states[i].L_P.norm() + h * dots[i].L_dot_P.norm();
    const double p = states[i].p_W.norm() + h * dots[i].p_dot_W.norm();
    consider(error5.q_dot.norm(), error3.q_dot.norm(), 0, 0.5);  // twice a quaternion: an angle
    consider(error5.L_dot_P.norm(), error3.L_dot_P.norm(), least_L, L);
    consider(error5.p_dot_W.norm(), error3.p_dot_W.norm(), least_p, p);
  }
  return worst;
}

/// end = start + h Σ weights[s] dots[s], of the states that have moved since the step began.
void advanceLaws(double h, const Weights& weights, std::size_t stages, const Workspace& workspace,
                 const std::vector<double>& start, std::vector<double>& end) {
  const std::size_t laws = start.size();
  for (std::size_t k : workspace.moving_laws) {
    double sum = 0;
    for (std::size_t s = 0; s < stages; ++s) sum += weights[s] * workspace.law_dots[s * laws + k];
    end[k] = start[k] + h * sum;
  }
}

/// All wrenches at a stage, and the rates of laws: those that move are added to those that have
/// moved before. Most do not: they are modes, or belong to what does not touch.
void evaluateWithLaws(const System& system, std::size_t stage, Workspace& workspace,
                      std::vector<double>& rates) {
  if (stage == 0) {
    workspace.moving_laws.clear();
    workspace.has_moved.assign(workspace.stages.laws.size(), 0);
  }
  evaluateAllWithRates(system, workspace.stages, workspace, rates);
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (rates[k] != 0 && !workspace.has_moved[k]) {
      workspace.has_moved[k] = 1;
      workspace.moving_laws.push_back(k);
    }
  std::copy(rates.begin(), rates.end(),
            workspace.law_dots.begin() + static_cast<std::ptrdiff_t>(stage * rates.size()));
}

/// The rates at all stages of a step of h, stage by stage.
void evaluateStages(const System& system, double h, const SystemState& states,
                    Workspace& workspace) {
  const std::size_t n = states.bodies.size();
  const std::size_t laws = system.law_states_change ? states.laws.size() : 0;
  std::vector<BodyStateDot>& dots = workspace.dots;
  dots.resize(kStages * n);
  workspace.law_dots.resize(kStages * laws);
  workspace.stages = states;
  std::vector<double> law_rates;
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    for (std::size_t i = 0; stage > 0 && i < n; ++i)
      workspace.stages.bodies[i] =
          stagePoint(states.bodies[i], weighted(dop853::kA[stage], stage, &dots[i], n), h);
    if (stage > 0 && laws > 0)
      advanceLaws(h, dop853::kA[stage], stage, workspace, states.laws, workspace.stages.laws);
    if (laws > 0)
      evaluateWithLaws(system, stage, workspace, law_rates);
    else
      evaluateAllWrenches(system, workspace.stages, workspace);
    for (std::size_t i = 0; i < n; ++i)
      dots[stage * n + i] =
          stateDot(*system.bodies[i], workspace.stages.bodies[i], workspace.wrenches[i]);
  }
}

void endStep(const System& system, double h, const Workspace& workspace, SystemState& states) {
  const std::size_t n = states.bodies.size(), laws = workspace.law_dots.size() / kStages;
  for (std::size_t i = 0; i < n; ++i)
    states.bodies[i] =
        stepEnd(states.bodies[i], weighted(dop853::kB, kStages, &workspace.dots[i], n), h);
  if (laws == 0) return;
  advanceLaws(h, dop853::kB, kStages, workspace, states.laws, states.laws);
  addSpin(system, states);
}

}  // namespace

// One step of order 8, with its estimate; infinity, and the step is not done, where the estimate
// says that the motion cannot be followed.
void dop853Step(const System& system, double h, SystemState& states, Workspace& workspace) {
  evaluateStages(system, h, states, workspace);
  workspace.wrenches_current = false;
  const auto estimate = [&](const StepBound& bound) {
    return bound.least_share > 0
               ? errorEstimate<true>(system, std::abs(h), states.bodies, workspace.dots, bound)
               : errorEstimate<false>(system, std::abs(h), states.bodies, workspace.dots, bound);
  };
  const StepBound follows;
  workspace.error = estimate(workspace.step_bound);
  // not (error <= limit), so that a step to infinity is not followed either
  if (!(workspace.error <= follows.error) && !(estimate(follows) <= follows.error)) {
    workspace.error = std::numeric_limits<double>::infinity();
    return;
  }
  endStep(system, h, workspace, states);
}

}  // namespace rigid_body_sim
