#include <cmath>

#include <Simbody.h>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Hunt–Crossley contact of spheres, of a stiff material: a ball, or, in place of a box, small
// spheres at its corners. Friction grows with the speed up to a transition of 1e-4 m/s; there is no
// sticking. Runge–Kutta–Merson over accuracies.

namespace rigid_body_sim::touch_peers {
namespace {

using SimTK::Vec3;

Vec3 vector(const Array3& v) { return {v[0], v[1], v[2]}; }

TouchRun simbodyRun(const TouchCase& c, double accuracy) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  SimTK::ContactTrackerSubsystem tracker(system);
  SimTK::CompliantContactSubsystem contacts(system, tracker);
  contacts.setTransitionVelocity(1e-4);
  SimTK::Force::UniformGravity(forces, matter, Vec3(0, 0, -kGravity));
  constexpr double kStiff = 1e10;  // [Pa]
  const double dissipation = c.restitution < 1 ? 1 - c.restitution : 0;
  const SimTK::ContactMaterial material(kStiff, dissipation, c.friction, c.friction, 0);
  // solid where x > 0 of its frame: turned to face up
  matter.Ground().updBody().addContactSurface(
      SimTK::Transform(SimTK::Rotation(0.5 * SimTK::Pi, SimTK::YAxis), Vec3(0)),
      SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), material));
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
  SimTK::MobilizedBody::Free body(matter.Ground(), SimTK::Transform(), rigid, SimTK::Transform());
  SimTK::State state = system.realizeTopology();
  const Vec3 turn = vector(c.rotation);
  const double half = turn.norm() / 2;
  const SimTK::Vec3 along = half > 0 ? Vec3(std::sin(half) / turn.norm() * turn) : Vec3(0);
  const SimTK::Rotation R(SimTK::Quaternion(std::cos(half), along[0], along[1], along[2]));
  body.setQToFitTransform(state, {R, vector(c.x_W)});
  body.setUToFitLinearVelocity(state, vector(c.v_W));
  body.setUToFitAngularVelocity(state, vector(c.w_W));
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(accuracy);
  integrator.initialize(state);
  const double begin = cpuTime();
  while (integrator.getTime() < c.duration) integrator.stepTo(c.duration, c.duration);
  std::string setting = std::to_string(std::lround(std::log10(accuracy)));
  TouchRun run{"accuracy 1e" + setting, cpuTime() - begin, {}};
  system.realize(integrator.getState(), SimTK::Stage::Position);
  const Vec3 x = body.getBodyOriginLocation(integrator.getState());
  run.x_W = {x[0], x[1], x[2]};
  return run;
}

const TouchRegistration kSimbodyTouch({"Simbody", {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, simbodyRun});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
