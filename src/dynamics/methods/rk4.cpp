#include <array>

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {

// The classical Runge–Kutta method on (x, q, p, L_P), attitude renormalised after the step.
//   0   |
//   1/2 | 1/2
//   1/2 | 0   1/2
//   1   | 0   0   1
//       | 1/6 1/3 1/3 1/6
void rk4Step(const System& system, double h, std::vector<BodyState>& states, Workspace& workspace) {
  constexpr std::array<double, 4> kNode{0, 0.5, 0.5, 1};
  constexpr std::array<double, 4> kWeight{1. / 6, 1. / 3, 1. / 3, 1. / 6};
  const std::size_t n = states.size();
  std::vector<BodyStateDot>& dots = workspace.dots;
  dots.assign(2 * n, BodyStateDot{});  // this stage's rates, then the weighted sum
  workspace.stages = states;
  for (std::size_t stage = 0; stage < 4; ++stage) {
    if (stage > 0)
      for (std::size_t i = 0; i < n; ++i)
        workspace.stages[i] = stagePoint(states[i], dots[i], kNode[stage] * h);
    evaluateWrenchesAndDrag(system, workspace.stages, workspace);
    for (std::size_t i = 0; i < n; ++i) {
      dots[i] = stateDot(*system.bodies[i], workspace.stages[i], workspace.wrenches[i]);
      accumulate(dots[i], kWeight[stage], dots[n + i]);
    }
  }
  for (std::size_t i = 0; i < n; ++i) states[i] = stepEnd(states[i], dots[n + i], h);
  workspace.wrenches_current = false;
}

}  // namespace rigid_body_sim
