#include <algorithm>
#include <cmath>
#include <utility>

#include <Simbody.h>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Hunt–Crossley contact of spheres, of a stiff material: a ball, or, in place of a box, small
// spheres at its corners. Friction grows with the speed up to a transition of 1e-4 m/s; there is no
// sticking. Runge–Kutta–Merson over accuracies. An ellipsoid: over speeds of transition, as what
// creeps does not roll; by backward differences (CPODES), as Runge–Kutta–Merson needs more than 20
// s below 1e-3 m/s.

namespace rigid_body_sim::touch_peers {
namespace {

using SimTK::Vec3;

Vec3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

/// [m] in the ground where an ellipsoid would rest as it stands.
double restDepth(const SimTK::MultibodySystem& system, const SimTK::MobilizedBody::Free& body,
                 SimTK::State state, const SimTK::Transform& pose) {
  double above = 0, below = 1e-2;
  for (int k = 0; k < 50; ++k) {
    const double depth = (above + below) / 2;
    body.setQToFitTransform(state, {pose.R(), pose.p() - Vec3(0, 0, depth)});
    system.realize(state, SimTK::Stage::Acceleration);
    (body.getBodyOriginAcceleration(state)[2] < 0 ? above : below) = depth;
  }
  return above;
}

/// The surfaces of a body, of a material, and its mass.
SimTK::Body::Rigid rigidBody(const TouchCase& c, const SimTK::ContactMaterial& material) {
  if (c.isEllipsoid()) {
    SimTK::Body::Rigid rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(vector(c.inertia))));
    rigid.addContactSurface(
        SimTK::Transform(SimTK::Rotation(c.shape_turn, SimTK::ZAxis), Vec3(0, 0, c.shape_up)),
        SimTK::ContactSurface(SimTK::ContactGeometry::Ellipsoid(vector(c.semi_axes)), material));
    return rigid;
  }
  const bool is_ball = c.radius > 0;
  const SimTK::UnitInertia unit = is_ball ? SimTK::UnitInertia::sphere(c.radius)
                                          : SimTK::UnitInertia::brick(0.5 * vector(c.box));
  SimTK::Body::Rigid rigid(SimTK::MassProperties(1, Vec3(0), SimTK::Inertia(unit)));
  constexpr double kCorner = 1e-3;  // [m]
  for (int k = 0; k < (is_ball ? 1 : 8); ++k) {
    const double radius = is_ball ? c.radius : kCorner;
    Vec3 place(0);
    for (int i = 0; i < 3 && !is_ball; ++i)
      place[i] = ((k >> i) & 1 ? 1 : -1) * (0.5 * c.box[static_cast<std::size_t>(i)] - kCorner);
    rigid.addContactSurface(
        SimTK::Transform(place),
        SimTK::ContactSurface(SimTK::ContactGeometry::Sphere(radius), material));
  }
  return rigid;
}

struct SimbodySetting {
  double modulus;     // [Pa]
  double transition;  // [m/s]
  double accuracy;
  bool is_stiff;  ///< by backward differences
};

TouchRun simbodyRun(const TouchCase& c, const SimbodySetting& set, std::string setting) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  SimTK::ContactTrackerSubsystem tracker(system);
  SimTK::CompliantContactSubsystem contacts(system, tracker);
  contacts.setTransitionVelocity(set.transition);
  SimTK::Force::UniformGravity(forces, matter, Vec3(0, 0, -kGravity));
  const double dissipation = c.restitution < 1 ? 1 - c.restitution : 0;
  const SimTK::ContactMaterial material(set.modulus, dissipation, c.friction, c.friction, 0);
  // solid where x > 0 of its frame: turned to face up
  matter.Ground().updBody().addContactSurface(
      SimTK::Transform(SimTK::Rotation(0.5 * SimTK::Pi, SimTK::YAxis), Vec3(0)),
      SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), material));
  SimTK::MobilizedBody::Free body(matter.Ground(), SimTK::Transform(), rigidBody(c, material),
                                  SimTK::Transform());
  SimTK::State state = system.realizeTopology();
  const Vec3 turn = vector(c.rotation);
  const double half = turn.norm() / 2;
  const SimTK::Vec3 along = half > 0 ? Vec3(std::sin(half) / turn.norm() * turn) : Vec3(0);
  const SimTK::Rotation R(SimTK::Quaternion(std::cos(half), along[0], along[1], along[2]));
  SimTK::Transform pose(R, vector(c.x_W));
  if (c.isEllipsoid()) pose.updP()[2] -= restDepth(system, body, state, pose);
  body.setQToFitTransform(state, pose);
  body.setUToFitLinearVelocity(state, vector(c.v_W));
  body.setUToFitAngularVelocity(state, vector(c.w_W));
  SimTK::RungeKuttaMersonIntegrator merson(system);
  SimTK::CPodesIntegrator differences(system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  SimTK::Integrator& integrator =
      set.is_stiff ? static_cast<SimTK::Integrator&>(differences) : merson;
  integrator.setAccuracy(set.accuracy);
  integrator.initialize(state);
  const double begin = cpuTime();
  // CPODES prints an error wherever it is asked for more than 500 steps at once
  const double slice = set.is_stiff ? 1e-3 : c.duration;  // [s]
  while (integrator.getTime() < c.duration) {
    const double next = std::min(integrator.getTime() + slice, c.duration);
    integrator.stepTo(next, c.duration);
  }
  TouchRun run{std::move(setting), cpuTime() - begin, {}};
  system.realize(integrator.getState(), SimTK::Stage::Position);
  const Vec3 x = body.getBodyOriginLocation(integrator.getState());
  const SimTK::Quaternion q =
      body.getBodyRotation(integrator.getState()).convertRotationToQuaternion();
  run.x_W = {x[0], x[1], x[2]};
  run.q = {q[1], q[2], q[3], q[0]};
  return run;
}

std::string tenTo(double exponent) { return "1e" + std::to_string(std::lround(exponent)); }

TouchRun simbodyTouch(const TouchCase& c, double accuracy) {
  return simbodyRun(c, {1e10, 1e-4, accuracy, false}, "accuracy " + tenTo(std::log10(accuracy)));
}

template <int digits>  // of the modulus
TouchRun simbodyRolling(const TouchCase& c, double transition) {
  return simbodyRun(c, {std::pow(10, digits), transition, 1e-7, true},
                    "transition " + tenTo(std::log10(transition)));
}

const TouchRegistration kSimbodyTouch(
    {"Simbody", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, simbodyTouch, {}});
const std::vector<double> kTransitions{1e-2, 1e-3, 1e-4, 1e-5};  // [m/s]
const TouchRegistration kSimbodyRolling({"Simbody, 1e10 Pa", {}, simbodyRolling<10>, kTransitions});
const TouchRegistration kSimbodyStiff({"Simbody, 1e11 Pa", {}, simbodyRolling<11>, kTransitions});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
