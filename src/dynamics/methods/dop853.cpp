#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/methods/dop853_coefficients.hpp"

namespace rigid_body_sim {
namespace {

using dop853::kStages;

/// What a step got wrong by its embedded estimates, the greatest of all bodies: attitude [rad],
/// angular momentum and momentum relative to their size and change, each by itself, so that a fast
/// flight does not hide a bad attitude. Where a body has come to rest on a stiff spring, momenta
/// are rounding and their relative errors mean nothing: see StepBound::idle.
double errorEstimate(const System& system, double h, const std::vector<BodyState>& states,
                     const std::vector<BodyStateDot>& dots, double idle) {
  const std::size_t n = states.size();
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    BodyStateDot error5, error3;
    for (std::size_t s = 0; s < kStages; ++s) {
      accumulate(dots[s * n + i], dop853::kE5[s], error5);
      accumulate(dots[s * n + i], dop853::kB[s], error3);
    }
    accumulate(dots[0 * n + i], -dop853::kB3_0, error3);
    accumulate(dots[8 * n + i], -dop853::kB3_8, error3);
    accumulate(dots[11 * n + i], -dop853::kB3_11, error3);
    const auto combined = [h](double e5, double e3) {
      const double size = std::hypot(e5, 0.1 * e3);
      return size > 0 ? h * e5 * (e5 / size) : 0.0;
    };
    // least: what does not count
    const auto relative = [](double e, double least, double scale) {
      return e <= least ? 0.0 : e / scale;
    };
    const Body& body = *system.bodies[i];
    const double least_L = idle * body.I.minCoeff() / h;
    const double least_p = idle * std::sqrt(body.I.maxCoeff() / body.mass) * body.mass / h;
    const double L = states[i].L_P.norm() + h * dots[i].L_dot_P.norm();
    const double p = states[i].p_W.norm() + h * dots[i].p_dot_W.norm();
    worst =
        std::max({worst, 2 * combined(error5.q_dot.norm(), error3.q_dot.norm()),
                  relative(combined(error5.L_dot_P.norm(), error3.L_dot_P.norm()), least_L, L),
                  relative(combined(error5.p_dot_W.norm(), error3.p_dot_W.norm()), least_p, p)});
  }
  return worst;
}

/// The rates at all stages of a step of h, stage by stage.
void evaluateStages(const System& system, double h, const std::vector<BodyState>& states,
                    Workspace& workspace) {
  const std::size_t n = states.size();
  std::vector<BodyStateDot>& dots = workspace.dots;
  dots.resize(kStages * n);
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    workspace.stages = states;
    for (std::size_t i = 0; i < n; ++i) {
      BodyStateDot sum;
      for (std::size_t s = 0; s < stage; ++s)
        accumulate(dots[s * n + i], dop853::kA[stage][s], sum);
      if (stage > 0) workspace.stages[i] = stagePoint(states[i], sum, h);
    }
    evaluateWrenchesAndDrag(system, workspace.stages, workspace);
    for (std::size_t i = 0; i < n; ++i)
      dots[stage * n + i] = stateDot(*system.bodies[i], workspace.stages[i], workspace.wrenches[i]);
  }
}

void endStep(double h, const std::vector<BodyStateDot>& dots, std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    BodyStateDot sum;
    for (std::size_t s = 0; s < kStages; ++s)
      accumulate(dots[s * states.size() + i], dop853::kB[s], sum);
    states[i] = stepEnd(states[i], sum, h);
  }
}

/// A step in equal parts. Returns the greatest estimate of a part; infinity, and leaves the step
/// unfinished, where a part cannot be followed.
double stepInParts(const System& system, double h, int parts, std::vector<BodyState>& states,
                   Workspace& workspace) {
  const StepBound follows, &bound = workspace.step_bound;
  const double part = h / parts;
  double worst = 0;
  for (int done = 0; done < parts; ++done) {
    evaluateStages(system, part, states, workspace);
    const auto estimate = [&](double idle) {
      return errorEstimate(system, std::abs(part), states, workspace.dots, idle);
    };
    const double error = estimate(bound.idle);
    // not (error <= limit), so that a step to infinity is not followed either
    if (!(error <= follows.error) && !(estimate(follows.idle) <= follows.error))
      return std::numeric_limits<double>::infinity();
    worst = std::max(worst, error);
    endStep(part, workspace.dots, states);
  }
  return worst;
}

}  // namespace

// One step of order 8; in equal parts where its own estimate says that it cannot follow so long a
// step, and where it exceeds the bound, unless shorter ones gain nothing more but rounding.
void dop853Step(const System& system, double h, std::vector<BodyState>& states,
                Workspace& workspace) {
  constexpr int kMostParts = 1 << 12;
  constexpr double kGain = 4;  // far below the 2⁸ of the order
  const std::vector<BodyState> start = states;
  double last_error = std::numeric_limits<double>::infinity();
  for (int parts = 1; parts <= kMostParts; parts *= 2) {
    const double error = stepInParts(system, h, parts, states, workspace);
    const bool gains = error <= last_error / kGain && parts < kMostParts;
    if (error <= workspace.step_bound.error || (std::isfinite(error) && !gains)) {
      workspace.wrenches_current = false;
      return;
    }
    last_error = error;
    states = start;
  }
  throw StepTooLong("dop853 cannot follow the motion, even in 4096 parts of a step");
}

}  // namespace rigid_body_sim
