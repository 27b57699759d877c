#include <cstdio>
#include <vector>

#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "tools/trade/cpu_time.hpp"

// What a step of each row costs, for one box under one force held at a body point: the numbers of
// Method::cost, relative to strang's.

namespace rigid_body_sim {
namespace {

constexpr int kSteps = 1000;

struct Run {
  System system;
  SystemState states;
  Workspace workspace;
};

Run leverRun(const Body& body) {
  PointWrench push;
  push.force = {1, 2, 12};
  push.point = {0.3, -0.1, 0.05};
  Run run;
  run.system.bodies = {&body};
  run.system.g_W = {0, 0, -9.81};
  HeldWrenchSum sum;
  sum.add(push);
  run.system.held = {sum.sum()};
  run.states.bodies.resize(1);
  run.states.bodies[0].L_P = body.I.cwiseProduct(Vector3d(1, 2, 1.5));
  run.states.bodies[0].L_W = run.states.bodies[0].L_P;
  return run;
}

/// [ns] of processor time of a step of 1 ms.
double stepCost(const Method& method, const Run& start) {
  const auto steps = [&](Run& run) {
    for (int i = 0; i < kSteps; ++i) method.step(run.system, 1e-3, run.states, run.workspace);
  };
  return 1e9 * undisturbedCpuTime(start, steps, 0.5) / kSteps;
}

void printCosts() {
  const Body body = makeBody("box", massProperties(Box{{1, 0.5, 0.25}}, 2));
  const Run start = leverRun(body);
  const double strang = stepCost(methodNamed("strang"), start);
  std::printf("%-20s %12s %10s\n", "row", "ns per step", "cost");
  for (const Method& method : catalogue()) {
    const double ns = stepCost(method, start);
    std::printf("%-20s %12.1f %10.2f\n", method.name, ns, ns / strang);
  }
}

}  // namespace
}  // namespace rigid_body_sim

int main() { rigid_body_sim::printCosts(); }
