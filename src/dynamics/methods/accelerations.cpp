#include "dynamics/methods/accelerations.hpp"

#include "dynamics/methods/pivots.hpp"

namespace rigid_body_sim {
namespace {

/// Of a law of gravity: its force goes to the acceleration of the body, its torque to the wrench.
void addGravity(const System& system, const SystemState& states, const ForceLaw& law,
                std::vector<Wrench>& wrenches, std::vector<BodyMotion>& motions) {
  std::vector<Wrench> own(wrenches.size());
  law.addWrenches({system.bodies, states.bodies}, own);
  for (const std::size_t i : law.members()) {
    motions[i].acceleration.g_W += own[i].f_W / system.bodies[i]->mass;
    motions[i].acceleration.centers.push_back(*law.gravityCenter());
    wrenches[i].tau_W += own[i].tau_W;
    wrenches[i].tau_P += own[i].tau_P;
  }
}

/// What is known of bodies on a pivot beside their angular acceleration.
void addPivots(const System& system, const SystemState& states, std::vector<BodyMotion>& motions) {
  const std::vector<Vector3d> forces_W = forcesOnPivoted(system, states);
  for (std::size_t k = 0; k < forces_W.size(); ++k) {
    const System::Pivot& pivot = system.pivots[k];
    BodyAcceleration& acceleration = motions[pivot.body].acceleration;
    acceleration.g_W = pivot.g_W;
    acceleration.felt_W = -pivot.g_W;
    acceleration.on_pivoted_W = forces_W[k];
  }
}

}  // namespace

std::vector<BodyMotion> motionsOf(const System& system, const SystemState& states) {
  Workspace workspace;
  std::vector<Wrench>& wrenches = workspace.wrenches;
  evaluateAppliedAndFlows(system, states, workspace);
  std::vector<BodyMotion> motions(states.bodies.size());
  for (BodyMotion& motion : motions) motion.acceleration.g_W = system.g_W;
  for (const auto& law : system.laws)
    if (law->gravityCenter())
      addGravity(system, states, *law, wrenches, motions);
    else
      law->addWrenches({system.bodies, states.bodies}, wrenches);
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    if (law.acts(with_own.own)) law.addWrenches(with_own, wrenches);
  });
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Body& body = *system.bodies[i];
    motions[i].state = states.bodies[i];
    const BodyStateDot dot = stateDot(body, states.bodies[i], wrenches[i]);
    motions[i].acceleration.felt_W = dot.p_dot_W / body.mass;
    motions[i].acceleration.w_dot_P = angularVelocity(body.inv_I, dot.L_dot_P);
  }
  if (!system.pivots.empty()) addPivots(system, states, motions);
  return motions;
}

std::vector<BodyMotion> restOf(const System& system, const SystemState& states) {
  std::vector<BodyMotion> motions(states.bodies.size());
  for (BodyMotion& motion : motions) motion.acceleration.g_W = system.g_W;
  std::vector<Wrench> torques(motions.size());  // of gravity, which others balance
  for (const auto& law : system.laws)
    if (law->gravityCenter()) addGravity(system, states, *law, torques, motions);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i].state = states.bodies[i];
    motions[i].acceleration.felt_W = -motions[i].acceleration.g_W;
  }
  return motions;
}

}  // namespace rigid_body_sim
