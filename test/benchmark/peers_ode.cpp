#include <memory>

#include <ode/ode.h>

#include "benchmark/peers_ladder.hpp"

// Gyroscopic mode on, finite rotations, both steppers. Nothing damps, limits or disables a body
// unless asked to. A force holds for one step.

namespace rigid_body_sim::peers {
namespace {

using Step = int (*)(dWorldID, dReal);

class OdeWorld {
 public:
  OdeWorld(const Problem& problem, double h, Step stepper)
      : problem_(problem),
        h_(h),
        step_(stepper),
        world_(dWorldCreate()),
        body_(dBodyCreate(world_)) {
    const auto &g = problem.g_W, &w = problem.w, &I = problem.I;
    dWorldSetGravity(world_, g[0], g[1], g[2]);
    dMass mass;
    dMassSetParameters(&mass, problem.mass, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetGyroscopicMode(body_, 1);
    dBodySetFiniteRotationMode(body_, 1);
    dBodySetAngularVel(body_, w[0], w[1], w[2]);
  }
  ~OdeWorld() { dWorldDestroy(world_); }
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  void step() {
    const auto &f = problem_.force_W, &p = problem_.arm_P;
    if (problem_.isPushed()) dBodyAddForceAtRelPos(body_, f[0], f[1], f[2], p[0], p[1], p[2]);
    step_(world_, h_);
  }

  Quaternion4 attitude() const {
    const dReal* q = dBodyGetQuaternion(body_);
    return {q[1], q[2], q[3], q[0]};
  }

 private:
  const Problem& problem_;
  double h_;
  Step step_;
  dWorldID world_;
  dBodyID body_;
};

std::vector<Run> odeRuns(const Problem& problem) {
  dInitODE2(0);
  std::vector<Run> runs;
  const auto add = [&](const char* name, Step step) {
    const std::vector<Run> more = steppedRuns(
        name, problem, [&](double h) { return std::make_unique<OdeWorld>(problem, h, step); });
    runs.insert(runs.end(), more.begin(), more.end());
  };
  add("step", dWorldStep);
  add("quick step", dWorldQuickStep);
  dCloseODE();
  return runs;
}

const Registration kOde({"ODE", odeRuns});

}  // namespace
}  // namespace rigid_body_sim::peers
