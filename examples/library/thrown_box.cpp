// A box is thrown. A thruster fixed to it, off its centre of mass, fires from 0.25 s to 1.75 s; at
// 1 s it gets a push that was not scheduled. Prints where the box is, ten times a second.
#include <cstdio>
#include <stdexcept>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

using rigid_body_sim::Body;
using rigid_body_sim::BodyFrameMotion;
using rigid_body_sim::PointWrench;
using rigid_body_sim::Simulation;
using rigid_body_sim::Vector3d;
using rigid_body_sim::World;

namespace {

constexpr std::size_t kBox = 0;  // index in World::bodies

World makeWorld() {
  World world;
  world.g_W = {0, 0, -9.80665};
  world.solver.time_step = 0.01;
  const rigid_body_sim::Shape shape = rigid_body_sim::Box{{0.1, 0.4, 0.9}};
  world.bodies.push_back(makeBody("box", massProperties(shape, 10)));

  const Vector3d force(0, 0, 12), no_torque(0, 0, 0), nozzle(0.05, 0.1, -0.45);
  PointWrench thruster = wrenchInBodyAxes(world.bodies, kBox, force, no_torque, nozzle);
  thruster.start = 0.25;
  thruster.end = 1.75;
  world.wrenches.push_back(thruster);
  return world;
}

rigid_body_sim::State thrown(const World& world) {
  BodyFrameMotion motion;
  motion.x_W = {0, 0, 1};
  motion.v_W = {1, 0, 8};
  motion.w_W = {0.1, 5, 0.1};
  rigid_body_sim::State state;
  state.bodies.push_back(toBodyState(world.bodies[kBox], motion));
  return state;
}

void push(Simulation& simulation) {
  const Vector3d force(30, 0, 0), no_torque(0, 0, 0);
  PointWrench wrench = wrenchAtCenterOfMass(simulation.world().bodies, kBox, force, no_torque);
  wrench.start = simulation.time();
  wrench.end = simulation.time() + 0.2;
  simulation.apply(rigid_body_sim::WrenchInput{"push", wrench});
}

void print(const Simulation& simulation) {
  const Body& box = simulation.world().bodies[kBox];
  const BodyFrameMotion m = toBodyFrameMotion(box, simulation.body(kBox));
  std::printf("%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", simulation.time(), m.x_W.x(),
              m.x_W.y(), m.x_W.z(), m.q_WB.x(), m.q_WB.y(), m.q_WB.z(), m.q_WB.w());
}

}  // namespace

int main() {
  try {
    const World world = makeWorld();
    Simulation simulation(world, thrown(world));
    std::puts("time,px,py,pz,qx,qy,qz,qw");
    print(simulation);
    for (int step = 1; step <= 200; ++step) {
      simulation.step();
      if (step == 100) push(simulation);
      if (step % 10 == 0) print(simulation);
    }
  } catch (const rigid_body_sim::SimulationDiverged& diverged) {
    std::fprintf(stderr, "thrown_box: %s\n", diverged.what());
    return 3;
  } catch (const std::invalid_argument& refused) {
    std::fprintf(stderr, "thrown_box: %s\n", refused.what());
    return 1;
  }
  return 0;
}
