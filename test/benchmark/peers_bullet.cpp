#include <limits>
#include <memory>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "benchmark/peers_ladder.hpp"
#include "tools/trade/cpu_time.hpp"

// In double precision. Rigid bodies with each of the three gyroscopic terms, and a multibody of one
// base by Runge–Kutta. No damping, no collisions, no sleep. A force holds for one step.

namespace rigid_body_sim::peers {
namespace {

btVector3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

btQuaternion quaternion(const Quaternion4& q) { return {q[0], q[1], q[2], q[3]}; }

Array3 array(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

Motion motionOf(const btVector3& x_W, const btVector3& v_W, const btQuaternion& q,
                const btVector3& w_W) {
  const Quaternion4 attitude{q.x(), q.y(), q.z(), q.w()};
  return {array(x_W), array(v_W), attitude, inBodyAxes(attitude, array(w_W))};
}

btVector3 spinOf(const Motion& m) { return vector(inWorldAxes(m.q, m.w_P)); }

struct Parts {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
};

/// A body with the gyroscopic term of these flags, at the start of a problem.
void place(const Problem& problem, int gyroscopic, btRigidBody& body) {
  body.setFlags(gyroscopic);
  body.setDamping(0, 0);
  body.setActivationState(DISABLE_DEACTIVATION);
  const Motion& start = problem.start;
  body.setCenterOfMassTransform(btTransform(quaternion(start.q), vector(start.x_W)));
  body.setLinearVelocity(vector(start.v_W));
  body.setAngularVelocity(spinOf(start));
}

class RigidBodyWorld {
 public:
  RigidBodyWorld(const Problem& problem, double h, int gyroscopic)
      : problem_(problem), h_(h), body_(problem.mass, nullptr, &shape_, vector(problem.I)) {
    world_.setGravity(vector(problem.g_W));
    place(problem, gyroscopic, body_);
    world_.addRigidBody(&body_, 0, 0);
  }
  ~RigidBodyWorld() { world_.removeRigidBody(&body_); }
  RigidBodyWorld(const RigidBodyWorld&) = delete;
  RigidBodyWorld& operator=(const RigidBodyWorld&) = delete;

  void step() {
    pullForStep(problem_, *this, [&](const Pull& pull) { apply(pull); });
    world_.stepSimulation(h_, 0);
  }

  Motion motion() const {
    return motionOf(body_.getCenterOfMassPosition(), body_.getLinearVelocity(),
                    body_.getOrientation(), body_.getAngularVelocity());
  }

 private:
  void apply(const Pull& pull) {
    body_.applyForce(vector(pull.force_W),
                     body_.getWorldTransform().getBasis() * vector(pull.arm_P));
    body_.applyTorque(vector(pull.torque_W));
  }

  const Problem& problem_;
  double h_;
  Parts parts_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&parts_.dispatcher, &parts_.broadphase, &solver_,
                                 &parts_.configuration};
  btSphereShape shape_{0.1};
  btRigidBody body_;
};

class MultiBodyWorld {
 public:
  MultiBodyWorld(const Problem& problem, double h)
      : problem_(problem),
        h_(h),
        body_(problem.wheels ? 3 : 0, hubOf(problem).mass, vector(hubOf(problem).I), false, false) {
    if (problem.wheels) addWheels(*problem.wheels);
    world_.setGravity(vector(problem.g_W));
    body_.useRK4Integration(true);
    body_.setLinearDamping(0);
    body_.setAngularDamping(0);
    body_.setMaxCoordinateVelocity(std::numeric_limits<double>::max());
    body_.finalizeMultiDof();
    const Motion& start = problem.start;
    body_.setBasePos(vector(start.x_W));
    body_.setWorldToBaseRot(quaternion(start.q).inverse());
    body_.setBaseVel(vector(start.v_W));
    body_.setBaseOmega(spinOf(start));
    world_.addMultiBody(&body_);
  }
  ~MultiBodyWorld() { world_.removeMultiBody(&body_); }
  MultiBodyWorld(const MultiBodyWorld&) = delete;
  MultiBodyWorld& operator=(const MultiBodyWorld&) = delete;

  void step() {
    pullForStep(problem_, *this, [&](const Pull& pull) { apply(pull); });
    if (drive_) turnWheels(drive_->next(h_));
    world_.stepSimulation(h_, 0);
  }

  /// The base keeps the rotation from the world to it.
  Motion motion() const {
    return motionOf(body_.getBasePos(), body_.getBaseVel(), body_.getWorldToBaseRot().inverse(),
                    body_.getBaseOmega());
  }

 private:
  void apply(const Pull& pull) {
    const btVector3 force = vector(pull.force_W);
    const btVector3 arm_W = body_.localDirToWorld(-1, vector(pull.arm_P));
    body_.addBaseForce(force);
    body_.addBaseTorque(arm_W.cross(force) + vector(pull.torque_W));
  }

  void addWheels(const ReactionWheels& wheels) {
    for (int k = 0; k < 3; ++k) {
      btVector3 axis(0, 0, 0);
      axis[k] = 1;
      body_.setupRevolute(k, wheels.mass, vector(wheelMoments(wheels, static_cast<std::size_t>(k))),
                          -1, btQuaternion::getIdentity(), axis, {0, 0, 0}, {0, 0, 0}, true);
    }
    drive_.emplace(wheels);
  }

  void turnWheels(const Array3& torque_P) {
    for (int k = 0; k < 3; ++k) body_.addJointTorque(k, torque_P[static_cast<std::size_t>(k)]);
  }

  const Problem& problem_;
  double h_;
  Parts parts_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_{&parts_.dispatcher, &parts_.broadphase, &solver_,
                                  &parts_.configuration};
  btMultiBody body_;
  std::optional<WheelDrive> drive_;
};

std::vector<Run> bulletRuns(const Problem& problem) {
  std::vector<Run> runs = steppedRuns("multibody, RK4", problem, [&](double h) {
    return std::make_unique<MultiBodyWorld>(problem, h);
  });
  if (problem.wheels) return runs;  // rigid bodies would need constraints
  const auto rigid = [&](const char* name, int gyroscopic) {
    const std::vector<Run> more = steppedRuns(name, problem, [&](double h) {
      return std::make_unique<RigidBodyWorld>(problem, h, gyroscopic);
    });
    runs.insert(runs.end(), more.begin(), more.end());
  };
  rigid("implicit (body)", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
  rigid("implicit (world)", BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD);
  rigid("explicit", BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);
  return runs;
}

Motion rigidBodyEnd(const Problem& problem, double h, int steps) {
  return endOf(RigidBodyWorld(problem, h, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY), steps);
}

Motion multiBodyEnd(const Problem& problem, double h, int steps) {
  return endOf(MultiBodyWorld(problem, h), steps);
}

double rigidBodyCrowd(const std::vector<Problem>& problems, double h, int steps) {
  Parts parts;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&parts.dispatcher, &parts.broadphase, &solver,
                                &parts.configuration);
  world.setGravity(vector(problems.front().g_W));
  btSphereShape shape(0.1);
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  for (const Problem& problem : problems) {
    bodies.push_back(
        std::make_unique<btRigidBody>(problem.mass, nullptr, &shape, vector(problem.I)));
    place(problem, BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY, *bodies.back());
    world.addRigidBody(bodies.back().get(), 0, 0);
  }
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k) world.stepSimulation(h, 0);
  const double seconds = cpuTime() - begin;
  for (const auto& body : bodies) world.removeRigidBody(body.get());
  return seconds;
}

const Registration kBullet({"Bullet",
                            bulletRuns,
                            {{"Bullet", rigidBodyEnd}, {"Bullet RK4", multiBodyEnd}},
                            {{"Bullet", rigidBodyCrowd}}});

}  // namespace
}  // namespace rigid_body_sim::peers
