#include "dynamics/methods/system.hpp"

#include <rigid_body_sim/dynamics/drag.hpp>

namespace rigid_body_sim {
namespace {

/// kFields: gravity and laws too.
template <bool kFields>
void evaluate(const System& system, const std::vector<BodyState>& states, Workspace& workspace) {
  std::vector<Wrench>& wrenches = workspace.wrenches;
  wrenches.resize(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    wrenches[i] = system.held[i].at(states[i]);
    if (kFields) wrenches[i].f_W += system.bodies[i]->mass * system.g_W;
  }
  for (const PointWrench& applied : system.coupled)
    addPointWrench(applied, states, wrenches[applied.body]);
  if (kFields)
    for (const auto& law : system.laws) law->addWrenches({system.bodies, states}, wrenches);
  ++workspace.evaluations;
}

void addAllDrag(const System& system, const std::vector<BodyState>& states,
                std::vector<Wrench>& wrenches) {
  if (!system.drags) return;
  for (std::size_t i = 0; i < states.size(); ++i)
    addDrag(*system.bodies[i], states[i], wrenches[i]);
}

}  // namespace

void evaluateWrenches(const System& system, const std::vector<BodyState>& states,
                      Workspace& workspace) {
  evaluate<true>(system, states, workspace);
}

void evaluateAppliedAndDrag(const System& system, const std::vector<BodyState>& states,
                            Workspace& workspace) {
  evaluate<false>(system, states, workspace);
  addAllDrag(system, states, workspace.wrenches);
}

void evaluateWrenchesAndDrag(const System& system, const std::vector<BodyState>& states,
                             Workspace& workspace) {
  evaluateWrenches(system, states, workspace);
  addAllDrag(system, states, workspace.wrenches);
}

}  // namespace rigid_body_sim
