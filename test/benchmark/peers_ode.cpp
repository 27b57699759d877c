#include <memory>

#include <ode/ode.h>

#include "benchmark/peers_ladder.hpp"
#include "tools/trade/cpu_time.hpp"

// Gyroscopic mode on, finite rotations, both steppers. Nothing damps, limits or disables a body
// unless asked to. A force holds for one step. A spring: as such a force, and as a joint that
// yields.

namespace rigid_body_sim::peers {
namespace {

Array3 array(const dReal* v) { return {v[0], v[1], v[2]}; }

using Step = int (*)(dWorldID, dReal);

dBodyID addBody(const Problem& problem, dWorldID world) {
  const dBodyID body = dBodyCreate(world);
  const auto& I = problem.I;
  const Motion& start = problem.start;
  const auto &x = start.x_W, &v = start.v_W, w = inWorldAxes(start.q, start.w_P);
  dMass mass;
  dMassSetParameters(&mass, problem.mass, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetGyroscopicMode(body, 1);
  dBodySetFiniteRotationMode(body, 1);
  const dQuaternion q{start.q[3], start.q[0], start.q[1], start.q[2]};
  dBodySetPosition(body, x[0], x[1], x[2]);
  dBodySetQuaternion(body, q);
  dBodySetLinearVel(body, v[0], v[1], v[2]);
  dBodySetAngularVel(body, w[0], w[1], w[2]);
  return body;
}

/// A joint of constant length, as soft as the spring, by the rule of ODE's manual for a spring
/// without damping in steps of h.
void addSpringJoint(const SpringToWorld& spring, double h, dWorldID world, dBodyID body) {
  const dJointID joint = dJointCreateDBall(world, nullptr);
  dJointAttach(joint, body, nullptr);
  const auto &at = spring.anchor_W, &arm = spring.arm_P;
  dVector3 end;
  dBodyGetRelPointPos(body, arm[0], arm[1], arm[2], end);
  dJointSetDBallAnchor1(joint, end[0], end[1], end[2]);
  dJointSetDBallAnchor2(joint, at[0], at[1], at[2]);
  dJointSetDBallDistance(joint, spring.rest_length);
  dJointSetDBallParam(joint, dParamERP, 1);
  dJointSetDBallParam(joint, dParamCFM, 1 / (h * spring.stiffness));
}

enum class SpringAs { kForce, kJoint };

class OdeWorld {
 public:
  OdeWorld(const Problem& problem, double h, Step stepper, SpringAs spring_as = SpringAs::kForce)
      : problem_(problem),
        h_(h),
        step_(stepper),
        world_(dWorldCreate()),
        body_(addBody(hubOf(problem), world_)) {
    const auto& g = problem.g_W;
    dWorldSetGravity(world_, g[0], g[1], g[2]);
    if (problem_.wheels) addWheels(*problem_.wheels);
    if (spring_as == SpringAs::kForce) return;
    addSpringJoint(*problem.spring, h, world_, body_);
    problem_.spring.reset();
  }
  ~OdeWorld() { dWorldDestroy(world_); }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  void step() {
    pullForStep(problem_, *this, [&](const Pull& pull) { apply(pull); });
    if (drive_) turnWheels(drive_->next(h_));
    step_(world_, h_);
  }

  Motion motion() const {
    const dReal* q = dBodyGetQuaternion(body_);
    const Quaternion4 attitude{q[1], q[2], q[3], q[0]};
    return {array(dBodyGetPosition(body_)), array(dBodyGetLinearVel(body_)), attitude,
            inBodyAxes(attitude, array(dBodyGetAngularVel(body_)))};
  }

 private:
  void apply(const Pull& pull) {
    const auto &f = pull.force_W, &p = pull.arm_P, &tau = pull.torque_W;
    dBodyAddForceAtRelPos(body_, f[0], f[1], f[2], p[0], p[1], p[2]);
    dBodyAddTorque(body_, tau[0], tau[1], tau[2]);
  }

  /// On hinges; what turns a wheel turns the body back.
  void addWheels(const ReactionWheels& wheels) {
    for (std::size_t k = 0; k < 3; ++k) {
      Problem wheel{"", wheels.mass, wheelMoments(wheels, k), problem_.start};
      hinges_[k] = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinges_[k], addBody(wheel, world_), body_);
      Array3 axis_P{};
      axis_P[k] = 1;
      const auto &x = problem_.start.x_W, axis = inWorldAxes(problem_.start.q, axis_P);
      dJointSetHingeAnchor(hinges_[k], x[0], x[1], x[2]);
      dJointSetHingeAxis(hinges_[k], axis[0], axis[1], axis[2]);
    }
    drive_.emplace(wheels);
  }

  void turnWheels(const Array3& torque_P) {
    for (std::size_t k = 0; k < 3; ++k) dJointAddHingeTorque(hinges_[k], torque_P[k]);
  }

  Problem problem_;  // without what a joint does
  double h_;
  Step step_;
  dWorldID world_;
  dBodyID body_;
  std::array<dJointID, 3> hinges_{};
  std::optional<WheelDrive> drive_;
};

std::vector<Run> odeRuns(const Problem& problem) {
  dInitODE2(0);
  std::vector<Run> runs;
  const auto add = [&](const char* name, Step step, SpringAs spring_as) {
    const std::vector<Run> more = steppedRuns(name, problem, [&](double h) {
      return std::make_unique<OdeWorld>(problem, h, step, spring_as);
    });
    runs.insert(runs.end(), more.begin(), more.end());
  };
  add("step", dWorldStep, SpringAs::kForce);
  add("quick step", dWorldQuickStep, SpringAs::kForce);
  if (problem.spring) add("step, joint as spring", dWorldStep, SpringAs::kJoint);
  dCloseODE();
  return runs;
}

Motion odeEnd(const Problem& problem, double h, int steps) {
  dInitODE2(0);
  const Motion end = endOf(OdeWorld(problem, h, dWorldStep), steps);
  dCloseODE();
  return end;
}

double odeCrowd(const std::vector<Problem>& bodies, double h, int steps) {
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  const auto& g = bodies.front().g_W;
  dWorldSetGravity(world, g[0], g[1], g[2]);
  for (const Problem& body : bodies) addBody(body, world);
  dWorldStep(world, h);  // takes its memory
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k) dWorldStep(world, h);
  const double seconds = cpuTime() - begin;
  dWorldDestroy(world);
  dCloseODE();
  return seconds;
}

const Registration kOde({"ODE", odeRuns, {{"ODE", odeEnd}}, {{"ODE", odeCrowd}}});

}  // namespace
}  // namespace rigid_body_sim::peers
