#include <cmath>

#include <btBulletDynamicsCommon.h>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Rigid bodies in double precision, on a static plane. No damping, no sleep, no margin of shapes
// that have one of their own.

namespace rigid_body_sim::touch_peers {
namespace {

btVector3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

/// A user's own shape, as Bullet provides for; where it meets a plane it is asked for nothing but
/// its lowest point.
class Ellipsoid : public btConvexInternalShape {
 public:
  explicit Ellipsoid(const TouchCase& c) : of_(c) { m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE; }

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& along) const override {
    const btVector3 unit = along.normalized();
    return vector(lowestPoint(of_, {unit.x(), unit.y(), unit.z()}));
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* along, btVector3* points,
                                                         int count) const override {
    for (int k = 0; k < count; ++k) points[k] = localGetSupportingVertexWithoutMargin(along[k]);
  }
  void calculateLocalInertia(btScalar /*mass*/, btVector3& inertia) const override {
    inertia = vector(of_.inertia);
  }
  const char* getName() const override { return "ellipsoid"; }
  /// Old points of contact go at once: it rolls.
  btScalar getContactBreakingThreshold(btScalar /*factor*/) const override { return 1e-5; }

 private:
  const TouchCase& of_;
};

/// What a user takes who writes no shape: a hull of so many points around it times half as many
/// along it.
void fill(btConvexHullShape& hull, const TouchCase& c, int around) {
  for (int i = 0; i <= around / 2; ++i)
    for (int k = 0; k < around; ++k) {
      const double a = 2 * SIMD_PI * i / around, b = 2 * SIMD_PI * k / around;
      const Array3& d = c.semi_axes;
      const btVector3 point(d[0] * std::cos(a), d[1] * std::sin(a) * std::cos(b),
                            d[2] * std::sin(a) * std::sin(b));
      hull.addPoint(point.rotate({0, 0, 1}, c.shape_turn) + btVector3(0, 0, c.shape_up), false);
    }
  hull.recalcLocalAabb();
  hull.setMargin(0);
}

TouchRun runWith(const TouchCase& c, double h, btCollisionShape& shape);

TouchRun bulletRun(const TouchCase& c, double h) {
  if (c.isEllipsoid()) {
    Ellipsoid ellipsoid(c);
    ellipsoid.setMargin(0);
    return runWith(c, h, ellipsoid);
  }
  btSphereShape ball(c.radius > 0 ? c.radius : 1);
  btBoxShape box(c.radius > 0 ? btVector3(1, 1, 1) : btVector3(0.5 * vector(c.box)));
  return runWith(c, h, c.radius > 0 ? static_cast<btCollisionShape&>(ball) : box);
}

template <int around>
TouchRun bulletHullRun(const TouchCase& c, double h) {
  btConvexHullShape hull;
  fill(hull, c, around);
  return runWith(c, h, hull);
}

TouchRun runWith(const TouchCase& c, double h, btCollisionShape& shape) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, -kGravity});
  world.getSolverInfo().m_restitutionVelocityThreshold = 0;
  btVector3 inertia = vector(c.inertia);
  if (!c.isEllipsoid()) shape.calculateLocalInertia(1, inertia);
  btRigidBody body(1, nullptr, &shape, inertia);
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
  const btQuaternion end = body.getOrientation();
  run.q = {end.x(), end.y(), end.z(), end.w()};
  world.removeRigidBody(&body);
  world.removeRigidBody(&ground);
  return run;
}

const TouchRegistration kBulletTouch({"Bullet", kSteps, bulletRun, kFineSteps});
const TouchRegistration kBulletHull({"Bullet, hull of 450", {}, bulletHullRun<30>, kSteps});
const TouchRegistration kBulletFineHull({"Bullet, hull of 45000", {}, bulletHullRun<300>, kSteps});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
