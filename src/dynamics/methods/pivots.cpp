#include "dynamics/methods/pivots.hpp"

#include "dynamics/actuators/actuator_law.hpp"

namespace rigid_body_sim {

HeldWrench heldOnPivot(const Body& body, HeldWrenchSum wrenches, System::Pivot& pivot) {
  PointWrench weight;
  weight.point = body.com_P;
  weight.force = body.mass * pivot.g_W;
  wrenches.add(weight);
  HeldWrench held = wrenches.sum();
  pivot.f_W = held.f_W;
  pivot.f_P = held.f_P;
  held.f_W.setZero();
  held.f_P.setZero();
  held.is_zero = held.torqueFree();
  return held;
}

std::vector<Vector3d> forcesOnPivoted(const System& system, const SystemState& states) {
  std::vector<Wrench> wrenches(states.bodies.size());
  for (const System::Pivot& pivot : system.pivots)
    wrenches[pivot.body].f_W = pivot.f_W + rotate(states.bodies[pivot.body].q_WP, pivot.f_P);
  for (const PointWrench& applied : system.coupled)
    addPointWrench(applied, states.bodies, wrenches[applied.body]);
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  for (const auto& law : system.laws) law->addWrenches(at, wrenches);
  for (const auto& law : system.flows) law->addWrenches(at, wrenches);
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    if (const auto* motors = dynamic_cast<const ActuatorLaw*>(&law))
      wrenches[motors->body()].f_W +=
          rotate(states.bodies[motors->body()].q_WP, motors->onPivot(with_own));
    else if (law.acts(with_own.own))
      law.addWrenches(with_own, wrenches);
  });
  std::vector<Vector3d> forces_W;
  for (const System::Pivot& pivot : system.pivots) forces_W.push_back(wrenches[pivot.body].f_W);
  return forces_W;
}

}  // namespace rigid_body_sim
