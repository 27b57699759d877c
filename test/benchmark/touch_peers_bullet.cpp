#include <cmath>

#include <btBulletDynamicsCommon.h>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Rigid bodies in double precision, on a static plane. No damping, no sleep, no margin of shapes
// that have one of their own.

namespace rigid_body_sim::touch_peers {
namespace {

btVector3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

TouchRun bulletRun(const TouchCase& c, double h) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, -kGravity});
  world.getSolverInfo().m_restitutionVelocityThreshold = 0;
  btSphereShape ball(c.radius > 0 ? c.radius : 1);
  btBoxShape box(c.radius > 0 ? btVector3(1, 1, 1) : btVector3(0.5 * vector(c.box)));
  btCollisionShape* shape = c.radius > 0 ? static_cast<btCollisionShape*>(&ball) : &box;
  btVector3 inertia;
  shape->calculateLocalInertia(1, inertia);
  btRigidBody body(1, nullptr, shape, inertia);
  btStaticPlaneShape plane({0, 0, 1}, 0);
  btRigidBody ground(0, nullptr, &plane);
  for (btRigidBody* each : {&body, &ground}) {
    each->setFriction(each == &body ? c.friction : 1);  // they are multiplied
    each->setRestitution(each == &body ? c.restitution : 1);
    each->setDamping(0, 0);
    each->setActivationState(DISABLE_DEACTIVATION);
  }
  const btVector3 turn = vector(c.rotation);
  const btQuaternion q =
      turn.length() > 0 ? btQuaternion(turn.normalized(), turn.length()) : btQuaternion(0, 0, 0, 1);
  body.setCenterOfMassTransform(btTransform(q, vector(c.x_W)));
  body.setLinearVelocity(vector(c.v_W));
  body.setAngularVelocity(vector(c.w_W));
  world.addRigidBody(&ground);
  world.addRigidBody(&body);
  const auto steps = static_cast<int>(std::lround(c.duration / h));
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k) world.stepSimulation(h, 0);
  TouchRun run{"h " + std::to_string(h), cpuTime() - begin, {}};
  const btVector3 x = body.getCenterOfMassPosition();
  run.x_W = {x.x(), x.y(), x.z()};
  world.removeRigidBody(&body);
  world.removeRigidBody(&ground);
  return run;
}

const TouchRegistration kBulletTouch({"Bullet", kSteps, bulletRun});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
