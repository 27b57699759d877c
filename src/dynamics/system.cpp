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
  for (const AppliedWrench& applied : system.coupled)
    addAppliedWrench(applied, states, wrenches[applied.body]);
  ++workspace.evaluations;
}

}  // namespace rigid_body_sim
