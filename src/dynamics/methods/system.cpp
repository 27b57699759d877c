#include "dynamics/methods/system.hpp"

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/methods/pivots.hpp"

namespace rigid_body_sim {
namespace {

void addStatelessLaws(const System& system, const SystemState& states,
                      std::vector<Wrench>& wrenches) {
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  for (const auto& law : system.laws) law->addWrenches(at, wrenches);
}

void addStatefulLaws(const System& system, const SystemState& states,
                     std::vector<Wrench>& wrenches) {
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    if (law.acts(with_own.own)) law.addWrenches(with_own, wrenches);
  });
}

/// kFields: gravity and laws too.
template <bool kFields>
void evaluate(const System& system, const SystemState& states, Workspace& workspace) {
  const std::vector<BodyState>& bodies = states.bodies;
  std::vector<Wrench>& wrenches = workspace.wrenches;
  wrenches.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    // zeros by themselves: a sum that is copied just after it was made is waited for
    if (system.held[i].is_zero)
      wrenches[i] = Wrench();
    else
      wrenches[i] = system.held[i].at(bodies[i]);
    if (kFields) wrenches[i].f_W += system.bodies[i]->mass * system.g_W;
  }
  for (const PointWrench& applied : system.coupled)
    addPointWrench(applied, bodies, wrenches[applied.body]);
  if (kFields) addStatelessLaws(system, states, wrenches);
  ++workspace.evaluations;
}

void addFlows(const System& system, const SystemState& states, std::vector<Wrench>& wrenches) {
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  for (const auto& law : system.flows) law->addWrenches(at, wrenches);
}

}  // namespace

void evaluateWrenches(const System& system, const SystemState& states, Workspace& workspace) {
  evaluate<true>(system, states, workspace);
  addStatefulLaws(system, states, workspace.wrenches);
  takeUpForces(system, workspace.wrenches);
}

void evaluateAppliedAndFlows(const System& system, const SystemState& states,
                             Workspace& workspace) {
  evaluate<false>(system, states, workspace);
  addFlows(system, states, workspace.wrenches);
}

void evaluateAllWrenches(const System& system, const SystemState& states, Workspace& workspace) {
  evaluateWrenches(system, states, workspace);
  addFlows(system, states, workspace.wrenches);
}

void evaluateAllWithRates(const System& system, const SystemState& states, Workspace& workspace,
                          std::vector<double>& rates) {
  evaluate<true>(system, states, workspace);
  rates.assign(states.laws.size(), 0);
  for (const System::StatefulLaw& stateful : system.stateful_laws) {
    const ForceLaw& law = *stateful.law;
    const ForceLaw::Bodies at{system.bodies, states.bodies, states.laws.data() + stateful.first};
    double* of_law = rates.data() + stateful.first;
    if (law.acts(at.own))
      law.addWrenchesAndRates(at, workspace.wrenches, of_law);
    else
      law.setRates(at, of_law);
  }
  takeUpForces(system, workspace.wrenches);
  addFlows(system, states, workspace.wrenches);
}

void evaluateLawRates(const System& system, const SystemState& states, std::vector<double>& rates) {
  rates.assign(states.laws.size(), 0);
  for (const System::StatefulLaw& stateful : system.stateful_laws)
    stateful.law->setRates({system.bodies, states.bodies, states.laws.data() + stateful.first},
                           rates.data() + stateful.first);
}

void addSpin(const System& system, SystemState& states) {
  for (const System::Driven& driven : system.driven) {
    const ActuatorDrive& drive = driven.law->drive();
    if (!drive.spins()) continue;
    BodyState& state = states.bodies[driven.body];
    state.L_W += rotate(state.q_WP, drive.at(states.laws[driven.state]).H_P);
  }
}

double externalPower(const System& system, const SystemState& states) {
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  double power = 0;
  for (const auto& law : system.laws) power += law->externalPower(at);
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    if (law.acts(with_own.own)) power += law.externalPower(with_own);
  });
  return power;
}

}  // namespace rigid_body_sim
