#include <cassert>
#include <stdexcept>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/resolve_wrench.hpp>

#include "dynamics/contact/buried.hpp"
#include "dynamics/run/coupling.hpp"
#include "scene/build/body_mass.hpp"
#include "scene/build/build_actuators.hpp"
#include "scene/build/build_imus.hpp"
#include "scene/build/build_laws.hpp"
#include "scene/build/check_scene.hpp"
#include "scene/build/pivot_rules.hpp"

namespace rigid_body_sim {
namespace {

Body bodyOf(const BodyDef& def) {
  // that of a fixed body is ignored; a plane has none, and any other is as good
  const MassProperties any{1, Vector3d::Zero(), Matrix3d::Identity()};
  Body body = makeBody(def.name, hasMass(def) ? massProperties(def) : any,
                       actuatorsOf(def.actuators), pivotOf(def));
  body.fixed = def.fixed;
  body.absent = def.absent;
  return body;
}

std::vector<PointWrench> wrenchesOf(const Scene& scene, const std::vector<Body>& bodies) {
  std::vector<PointWrench> wrenches;
  if (scene.wrenches.empty()) return wrenches;  // a table of many frames costs more than the bodies
  wrenches.reserve(scene.wrenches.size());
  const FrameTable frames(scene, bodies);
  for (std::size_t i = 0; i < scene.wrenches.size(); ++i) {
    const ResolvedWrench resolved = resolveWrench(scene.wrenches[i], bodies, frames);
    if (!resolved.fault.empty())
      throw SceneError(scene.source, scene.wrenches[i].line,
                       "wrenches[" + std::to_string(i) + "]: " + resolved.fault);
    wrenches.push_back(resolved.wrench);
  }
  return wrenches;
}

/// Refuses an integrator that does not support what acts in the scene.
void checkIntegrator(const Scene& scene, const World& world) {
  if (world.solver.integrator == "auto") return;
  try {
    requireSupport(world);
  } catch (const std::invalid_argument& refused) {
    throw SceneError(scene.source, scene.integrator_line, refused.what());
  }
}

BodyFrameMotion motionOf(const BodyDef& def) {
  BodyFrameMotion motion;
  motion.x_W = def.position;
  motion.q_WB = def.orientation;
  const bool turned = def.twist.in_body_axes;
  motion.v_W = turned ? rotate(def.orientation, def.twist.linear) : def.twist.linear;
  motion.w_W = turned ? rotate(def.orientation, def.twist.angular) : def.twist.angular;
  return motion;
}

}  // namespace

World buildWorld(const Scene& scene) {
  checkScene(scene);
  World world;
  world.bodies.reserve(scene.bodies.size());
  for (const BodyDef& def : scene.bodies) world.bodies.push_back(bodyOf(def));
  if (scene.gravity) world.g_W = *scene.gravity;
  world.wrenches = wrenchesOf(scene, world.bodies);
  world.commands = commandsOf(scene, world.bodies);
  world.has_medium = scene.medium.has_value();
  world.laws = lawsOf(scene, world.bodies);
  world.gravity_centers = gravityCentersOf(scene);
  world.imus = imusOf(scene);
  world.solver = {scene.integrator, scene.time_step,        scene.tolerance,
                  scene.horizon,    scene.tolerance_stated, scene.threads};
  world.fingerprint = scene.fingerprint;
  checkIntegrator(scene, world);
  return world;
}

State initialState(const Scene& scene, const World& world) {
  assert(scene.bodies.size() == world.bodies.size());
  State state;
  state.bodies.reserve(world.bodies.size());
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const BodyDef& def = scene.bodies[i];
    state.bodies.push_back(toBodyState(world.bodies[i], motionOf(def)));
    const BodyState& s = state.bodies.back();
    if (!(s.x_W.allFinite() && s.p_W.allFinite() && s.L_W.allFinite() && s.L_P.allFinite()))
      throw SceneError(scene.source, def.line,
                       "body '" + def.name + "': its position and momenta must be finite");
  }
  if (const auto buried = findBuried(world, state.bodies))
    throw SceneError(scene.source, scene.bodies[buried->body].line, buried->fault);
  return state;
}

}  // namespace rigid_body_sim
