#include <memory>

#include <Simbody.h>

#include "benchmark/peers_ladder.hpp"

// A body on a free mobilizer, by the integrators of order 4 and more, each over a ladder of
// accuracies. The force is evaluated at every stage.

namespace rigid_body_sim::peers {
namespace {

SimTK::Vec3 vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

template <class Integrator>
class SimbodyWorld {
 public:
  SimbodyWorld(const Problem& problem, double accuracy)
      : body_(matter_.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(
                                    problem.mass, SimTK::Vec3(0),
                                    SimTK::Inertia(problem.I[0], problem.I[1], problem.I[2])))),
        integrator_(system_) {
    const SimTK::Vec3 g = vector(problem.g_W);
    if (g.norm() > 0) SimTK::Force::UniformGravity(forces_, matter_, g);
    if (problem.isPushed())
      SimTK::Force::ConstantForce(forces_, body_, vector(problem.arm_P), vector(problem.force_W));
    SimTK::State state = system_.realizeTopology();
    body_.setUToFitAngularVelocity(state, vector(problem.w));
    integrator_.setAccuracy(accuracy);
    integrator_.initialize(state);
  }

  /// Reports are interpolated and cost next to nothing; CPODES takes at most 500 steps for each.
  void run(double duration) {
    constexpr double kReport = 0.5;  // [s]
    while (integrator_.getTime() < duration)
      integrator_.stepTo(std::min(integrator_.getTime() + kReport, duration), duration);
  }

  Quaternion4 attitude() const {
    const SimTK::State& state = integrator_.getState();
    system_.realize(state, SimTK::Stage::Position);
    const SimTK::Vec4 q =
        body_.getBodyRotation(state).convertRotationToQuaternion().asVec4();  // w first
    return {q[1], q[2], q[3], q[0]};
  }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Free body_;
  Integrator integrator_;
};

template <class Integrator>
void addLadder(const char* name, const Problem& problem, std::vector<Run>& runs) {
  constexpr double kLongest = 5;  // [s] of processor time
  double error = 1;
  for (double accuracy = 1e-2; accuracy > 1e-14 && error > kTargets.back(); accuracy /= 10) {
    try {
      runs.push_back(timedRun(
          label(name, "accuracy", accuracy),
          [&] { return std::make_unique<SimbodyWorld<Integrator>>(problem, accuracy); },
          [&](auto& world) { world.run(problem.duration); }));
    } catch (const std::exception&) {
      break;  // it cannot be had so accurate
    }
    error = errorOf(runs.back(), problem);
    if (runs.back().seconds > kLongest) break;
  }
}

std::vector<Run> simbodyRuns(const Problem& problem) {
  std::vector<Run> runs;
  addLadder<SimTK::RungeKuttaMersonIntegrator>("RK-Merson", problem, runs);
  addLadder<SimTK::RungeKuttaFeldbergIntegrator>("RK-Fehlberg", problem, runs);
  addLadder<SimTK::CPodesIntegrator>("CPODES", problem, runs);
  return runs;
}

const Registration kSimbody({"Simbody", simbodyRuns});

}  // namespace
}  // namespace rigid_body_sim::peers
