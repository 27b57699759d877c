#include <memory>

#include <Simbody.h>

#include "benchmark/peers_ladder.hpp"

// A body on a free mobilizer, by the integrators of order 4 and more, each over a ladder of
// accuracies. The force is evaluated at every stage.

namespace rigid_body_sim::peers {
namespace {

SimTK::Vec3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

Array3 array(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

Motion motionOf(const SimTK::MobilizedBody& body, const SimTK::State& state) {
  const SimTK::Vec4 q =
      body.getBodyRotation(state).convertRotationToQuaternion().asVec4();  // w first
  const Quaternion4 attitude{q[1], q[2], q[3], q[0]};
  return {array(body.getBodyOriginLocation(state)), array(body.getBodyOriginVelocity(state)),
          attitude, inBodyAxes(attitude, array(body.getBodyAngularVelocity(state)))};
}

class PullForce final : public SimTK::Force::Custom::Implementation {
 public:
  PullForce(const Problem& problem, const SimTK::MobilizedBody& body)
      : problem_(problem), body_(body) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& loads,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector&) const override {
    for (const Pull& pull : problem_.pulls(motionOf(body_, state))) {
      body_.applyForceToBodyPoint(state, vector(pull.arm_P), vector(pull.force_W), loads);
      body_.applyBodyTorque(state, vector(pull.torque_W), loads);
    }
  }

  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
  const Problem& problem_;
  const SimTK::MobilizedBody& body_;
};

SimTK::Body::Rigid rigid(double mass, const Array3& I) {
  return SimTK::Body::Rigid(
      SimTK::MassProperties(mass, SimTK::Vec3(0), SimTK::Inertia(I[0], I[1], I[2])));
}

template <class Integrator>
class SimbodyWorld {
 public:
  explicit SimbodyWorld(const Problem& problem)
      : problem_(problem),
        body_(matter_.Ground(), rigid(hubOf(problem).mass, hubOf(problem).I)),
        integrator_(system_) {
    if (problem.wheels) addWheels(*problem.wheels);
    const SimTK::Vec3 g = vector(problem.g_W);
    if (g.norm() > 0) SimTK::Force::UniformGravity(forces_, matter_, g);
    if (problem.isPushed())
      SimTK::Force::ConstantForce(forces_, body_, vector(problem.arm_P), vector(problem.force_W));
    if (const auto& spring = problem.spring)
      SimTK::Force::TwoPointLinearSpring(forces_, matter_.Ground(), vector(spring->anchor_W), body_,
                                         vector(spring->arm_P), spring->stiffness,
                                         spring->rest_length);
    if (problem.pulls) SimTK::Force::Custom(forces_, new PullForce(problem, body_));  // taken over
    start_ = system_.realizeTopology();
    const Motion& start = problem.start;
    const SimTK::Quaternion q(start.q[3], start.q[0], start.q[1], start.q[2]);
    body_.setQToFitTransform(start_, {SimTK::Rotation(q), vector(start.x_W)});
    body_.setUToFitLinearVelocity(start_, vector(start.v_W));
    body_.setUToFitAngularVelocity(start_, vector(inWorldAxes(start.q, start.w_P)));
  }

  void setAccuracy(double accuracy) {
    integrator_.setAccuracy(accuracy);
    integrator_.initialize(start_);
  }

  void setStep(double h) {
    integrator_.setFixedStepSize(h);
    integrator_.initialize(start_);
  }

  /// From one command of the wheels to the next.
  void run(double duration) {
    if (!problem_.wheels) return runTo(duration, duration);
    const ReactionWheels& wheels = *problem_.wheels;
    for (std::size_t i = 0; i < wheels.commands.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        motors_[k].setMobilityForce(integrator_.updAdvancedState(), wheels.commands[i].torque_P[k]);
      integrator_.reinitialize(SimTK::Stage::Dynamics, false);
      runTo(wheels.endOf(i, duration), duration);
    }
  }

  Motion motion() const {
    const SimTK::State& state = integrator_.getState();
    system_.realize(state, SimTK::Stage::Velocity);
    return motionOf(body_, state);
  }

 private:
  /// Reports are interpolated and cost next to nothing; CPODES takes at most 500 steps for each.
  void runTo(double end, double duration) {
    const double report = std::max(0.5, duration / 1000);  // [s]
    while (integrator_.getTime() < end)
      integrator_.stepTo(std::min(integrator_.getTime() + report, end), end);
  }

  /// On pins, the axes of which are z.
  void addWheels(const ReactionWheels& wheels) {
    for (int k = 0; k < 3; ++k) {
      const SimTK::Transform pin(
          SimTK::Rotation(SimTK::UnitVec3(SimTK::CoordinateAxis(k)), SimTK::ZAxis));
      const SimTK::MobilizedBody::Pin wheel(
          body_, pin, rigid(wheels.mass, wheelMoments(wheels, static_cast<std::size_t>(k))), pin);
      motors_[static_cast<std::size_t>(k)] =
          SimTK::Force::MobilityDiscreteForce(forces_, wheel, SimTK::MobilizerUIndex(0));
    }
  }

  const Problem& problem_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::MobilizedBody::Free body_;
  std::array<SimTK::Force::MobilityDiscreteForce, 3> motors_;
  Integrator integrator_;
  SimTK::State start_;
};

template <class Integrator>
void addLadder(const char* name, const Problem& problem, std::vector<Run>& runs) {
  constexpr double kLongest = 5;  // [s] of processor time
  double error = 1;
  for (double accuracy = 1e-2; accuracy > 1e-14 && error > kTargets.back(); accuracy /= 10) {
    try {
      runs.push_back(timedRun(
          label(name, "accuracy", accuracy),
          [&] {
            auto world = std::make_unique<SimbodyWorld<Integrator>>(problem);
            world->setAccuracy(accuracy);
            return world;
          },
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

using MersonWorld = SimbodyWorld<SimTK::RungeKuttaMersonIntegrator>;

Motion fixedStepEnd(const Problem& problem, double h, int steps) {
  MersonWorld world(problem);
  world.setStep(h);
  world.run(h * steps);
  return world.motion();
}

/// In steps of its own.
Motion accurateEnd(const Problem& problem, double h, int steps) {
  MersonWorld world(problem);
  world.setAccuracy(1e-9);
  world.run(h * steps);
  return world.motion();
}

const Registration kSimbody({"Simbody",
                             simbodyRuns,
                             {{"Simbody", fixedStepEnd}, {"Simbody 1e-9", accurateEnd}}});

}  // namespace
}  // namespace rigid_body_sim::peers
