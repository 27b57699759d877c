#include <cmath>

#include <ode/ode.h>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Hard contact (no CFM, the usual ERP), friction by the pyramid that is proportional to the normal
// force, the big-matrix stepper.

namespace rigid_body_sim::touch_peers {
namespace {

struct Meeting {
  const TouchCase* of;
  dWorldID world;
  dJointGroupID joints;
};

void meet(void* data, dGeomID a, dGeomID b) {
  const auto& meeting = *static_cast<const Meeting*>(data);
  constexpr int kMax = 8;
  dContact contacts[kMax];
  const int count = dCollide(a, b, kMax, &contacts[0].geom, sizeof(dContact));
  for (int k = 0; k < count; ++k) {
    dSurfaceParameters& surface = contacts[k].surface;
    surface = {};
    surface.mode = dContactApprox1 | dContactBounce;
    surface.mu = meeting.of->friction;
    surface.bounce = meeting.of->restitution;
    surface.bounce_vel = 0;
    dJointAttach(dJointCreateContact(meeting.world, meeting.joints, &contacts[k]), dGeomGetBody(a),
                 dGeomGetBody(b));
  }
}

/// ODE has no ellipsoid: a contact joint at its lowest point, as a geometry class of the user
/// makes.
void meetByLowestPoint(const Meeting& meeting, dBodyID body) {
  const dReal *R = dBodyGetRotation(body), *x = dBodyGetPosition(body);
  const Array3 r = lowestPoint(*meeting.of, {-R[8], -R[9], -R[10]});
  dContact contact{};
  for (int i = 0; i < 3; ++i)
    contact.geom.pos[i] = x[i] + R[4 * i] * r[0] + R[4 * i + 1] * r[1] + R[4 * i + 2] * r[2];
  contact.geom.normal[2] = 1;
  contact.geom.depth = -contact.geom.pos[2];
  if (contact.geom.depth < 0) return;
  contact.surface.mode = dContactApprox1;
  contact.surface.mu = meeting.of->friction;
  dJointAttach(dJointCreateContact(meeting.world, meeting.joints, &contact), body, nullptr);
}

TouchRun odeRun(const TouchCase& c, double h) {
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, -kGravity);
  const dSpaceID space = dSimpleSpaceCreate(nullptr);
  dCreatePlane(space, 0, 0, 1, 0);
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  const bool is_ball = c.radius > 0, is_ellipsoid = c.isEllipsoid();
  if (is_ellipsoid)
    dMassSetParameters(&mass, 1, 0, 0, 0, c.inertia[0], c.inertia[1], c.inertia[2], 0, 0, 0);
  else if (is_ball)
    dMassSetSphereTotal(&mass, 1, c.radius);
  else
    dMassSetBoxTotal(&mass, 1, c.box[0], c.box[1], c.box[2]);
  dBodySetMass(body, &mass);
  if (!is_ellipsoid)
    dGeomSetBody(
        is_ball ? dCreateSphere(space, c.radius) : dCreateBox(space, c.box[0], c.box[1], c.box[2]),
        body);
  dBodySetFiniteRotationMode(body, 1);
  dBodySetPosition(body, c.x_W[0], c.x_W[1], c.x_W[2]);
  const double angle = std::hypot(c.rotation[0], c.rotation[1], c.rotation[2]);
  dMatrix3 R;
  if (angle > 0) {
    dRFromAxisAndAngle(R, c.rotation[0], c.rotation[1], c.rotation[2], angle);
    dBodySetRotation(body, R);
  }
  dBodySetLinearVel(body, c.v_W[0], c.v_W[1], c.v_W[2]);
  dBodySetAngularVel(body, c.w_W[0], c.w_W[1], c.w_W[2]);
  Meeting meeting{&c, world, dJointGroupCreate(0)};
  const auto steps = static_cast<int>(std::lround(c.duration / h));
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k) {
    if (is_ellipsoid)
      meetByLowestPoint(meeting, body);
    else
      dSpaceCollide(space, &meeting, meet);
    dWorldStep(world, h);
    dJointGroupEmpty(meeting.joints);
  }
  TouchRun run{"h " + std::to_string(h), cpuTime() - begin, {}};
  const dReal* x = dBodyGetPosition(body);
  run.x_W = {x[0], x[1], x[2]};
  const dReal* q = dBodyGetQuaternion(body);
  run.q = {q[1], q[2], q[3], q[0]};
  dJointGroupDestroy(meeting.joints);
  dSpaceDestroy(space);
  dWorldDestroy(world);
  dCloseODE();
  return run;
}

const TouchRegistration kOdeTouch({"ODE", kSteps, odeRun, kFineSteps});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
