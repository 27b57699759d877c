#include <array>

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {

// The classical Runge–Kutta method on (x, q, p, L_P), attitude renormalised after the step.
//   0   |
//   1/2 | 1/2
//   1/2 | 0   1/2
//   1   | 0   0   1
//       | 1/6 1/3 1/3 1/6
void rk4Step(const System& system, double h, SystemState& states, Workspace& workspace) {
  constexpr std::array<double, 4> kNode{0, 0.5, 0.5, 1};
  constexpr std::array<double, 4> kWeight{1. / 6, 1. / 3, 1. / 3, 1. / 6};
  const std::size_t n = states.bodies.size();
  std::vector<BodyStateDot>& dots = workspace.dots;
  dots.assign(2 * n, BodyStateDot{});  // this stage's rates, then the weighted sum
  std::vector<double> law_sum(system.law_states_change ? states.laws.size() : 0);
  std::vector<double> law_dots(law_sum.size());
  workspace.stages = states;
  for (std::size_t stage = 0; stage < 4; ++stage) {
    if (stage > 0)
      for (std::size_t i = 0; i < n; ++i)
        workspace.stages.bodies[i] = stagePoint(states.bodies[i], dots[i], kNode[stage] * h);
    for (std::size_t k = 0; stage > 0 && k < law_sum.size(); ++k)
      workspace.stages.laws[k] = states.laws[k] + kNode[stage] * h * law_dots[k];
    evaluateAllWrenches(system, workspace.stages, workspace);
    for (std::size_t i = 0; i < n; ++i) {
      dots[i] = stateDot(*system.bodies[i], workspace.stages.bodies[i], workspace.wrenches[i]);
      accumulate(dots[i], kWeight[stage], dots[n + i]);
    }
    if (!system.law_states_change) continue;
    evaluateLawRates(system, workspace.stages, law_dots);
    for (std::size_t k = 0; k < law_sum.size(); ++k) law_sum[k] += kWeight[stage] * law_dots[k];
  }
  for (std::size_t i = 0; i < n; ++i) states.bodies[i] = stepEnd(states.bodies[i], dots[n + i], h);
  if (!law_sum.empty()) {
    for (std::size_t k = 0; k < law_sum.size(); ++k) states.laws[k] += h * law_sum[k];
    addSpin(system, states);
  }
  workspace.wrenches_current = false;
}

}  // namespace rigid_body_sim
