#include <rigid_body_sim/dynamics/drag.hpp>
#include <rigid_body_sim/dynamics/system.hpp>

namespace rigid_body_sim {

void evaluateWrenches(const System& system, const std::vector<BodyState>& states,
                      Workspace& workspace) {
  std::vector<Wrench>& wrenches = workspace.wrenches;
  wrenches.resize(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    wrenches[i] = system.held[i].at(states[i]);
    wrenches[i].f_W += system.bodies[i]->mass * system.g_W;
  }
  for (const PointWrench& applied : system.coupled)
    addPointWrench(applied, states, wrenches[applied.body]);
  for (const auto& law : system.laws) law->addWrenches({system.bodies, states}, wrenches);
  ++workspace.evaluations;
}

void evaluateWrenchesAndDrag(const System& system, const std::vector<BodyState>& states,
                             Workspace& workspace) {
  evaluateWrenches(system, states, workspace);
  if (!system.drags) return;
  for (std::size_t i = 0; i < states.size(); ++i)
    addDrag(*system.bodies[i], states[i], workspace.wrenches[i]);
}

}  // namespace rigid_body_sim
