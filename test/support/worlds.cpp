#include "support/worlds.hpp"

#include <memory>
#include <utility>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/central_gravity.hpp>

namespace rigid_body_sim::test {

Body principalBody(const std::string& name, double mass, const Vector3d& I) {
  return makeBody(name, {mass, Vector3d::Zero(), I.asDiagonal()});
}

Body bodyOnPivot(const std::string& name, const Vector3d& point_B) {
  Matrix3d I_Bcm;
  I_Bcm << 0.5, 0.02, -0.03, 0.02, 0.7, 0.05, -0.03, 0.05, 0.9;
  return makeBody(name, {2, {0.1, 0.05, -0.2}, I_Bcm}, {}, point_B);
}

std::size_t Bench::add(const Body& body, const BodyFrameMotion& motion) {
  world.bodies.push_back(body);
  initial.bodies.push_back(toBodyState(body, motion));
  return world.bodies.size() - 1;
}

void Bench::fix(std::size_t body) {
  world.bodies[body].fixed = true;
  BodyState& start = initial.bodies[body];
  start.p_W = start.L_W = start.L_P = Vector3d::Zero();
}

void Bench::addSpring(const Spring::End& from, const Spring::End& to,
                      const Spring::Constants& constants) {
  world.laws.push_back(std::make_shared<Spring>(from, to, constants));
  reference_laws.push_back(reference::spring(from, to, constants));
}

void Bench::addCentralGravity(std::size_t body, const Vector3d& center, double mu, bool gradient) {
  world.laws.push_back(std::make_shared<CentralGravity>(body, center, mu, gradient));
  reference_laws.push_back(reference::centralGravity(body, center, mu, gradient));
}

void Bench::addDrag(std::size_t body, const Drag::Coefficients& coefficients) {
  world.laws.push_back(std::make_shared<Drag>(body, coefficients));
  reference_laws.push_back(reference::drag(body, coefficients));
}

void Bench::addMediumDrag(std::size_t body, const MediumDrag::Coefficients& drag,
                          const Vector3d& w_W) {
  world.laws.push_back(std::make_shared<MediumDrag>(body, drag, w_W));
  reference_laws.push_back(reference::mediumDrag(body, drag, w_W));
}

void Bench::addBuoyancy(std::size_t body, double displaced, const Vector3d& centroid_P) {
  world.laws.push_back(std::make_shared<Buoyancy>(body, displaced, centroid_P, world.g_W));
  reference_laws.push_back(reference::buoyancy(body, displaced, centroid_P, world.g_W));
}

Simulation Bench::simulation(const std::string& integrator, double time_step) const {
  World copy = world;
  copy.solver.integrator = integrator;
  copy.solver.time_step = time_step;
  return Simulation(std::move(copy), initial);
}

State Bench::run(const std::string& integrator, double duration, int steps) const {
  Simulation sim = simulation(integrator, duration / steps);
  for (int i = 0; i < steps; ++i) sim.step();
  return sim.state();
}

BodyFrameMotion tumbling(const Vector3d& v_W, const Vector3d& w_B, const Quaterniond& q_WB) {
  BodyFrameMotion motion;
  motion.q_WB = q_WB;
  motion.v_W = v_W;
  motion.w_W = rotate(q_WB, w_B);
  return motion;
}

Bench complexBox() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.8};
  bench.add(principalBody("box", 10, {9.7 / 12, 8.2 / 12, 1.7 / 12}),
            tumbling({-2, 2, 8}, {0.1, 5, 0.1}));
  return bench;
}

Bench restingBox() {
  Bench bench;
  bench.add(principalBody("box", 2, {1, 2, 2.5}), BodyFrameMotion());
  return bench;
}

PointWrench worldForce(const Vector3d& force, double start, double end) {
  PointWrench push;
  push.force = force;
  push.start = start;
  push.end = end;
  return push;
}

Bench pushedBox(std::size_t axes, std::size_t point_frame, double strength) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  const Vector3d I = 2. / 12 * Vector3d(0.25 + 0.0625, 1 + 0.0625, 1 + 0.25);
  bench.add(principalBody("box", 2, I), tumbling({0.5, 0, 1}, {1, -0.7, 0.4}));
  PointWrench push;
  push.body = 0;
  push.axes = axes;
  push.point_frame = point_frame;
  push.force = strength * Vector3d(1, 2, 12);
  push.torque = strength * Vector3d(0.2, 0, -0.1);
  push.point = {0.3, -0.1, 0.05};
  bench.world.wrenches.push_back(push);
  return bench;
}

}  // namespace rigid_body_sim::test
