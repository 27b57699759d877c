#include <cstdio>
#include <limits>
#include <string>

#include "support/random_bodies.hpp"
#include "support/worlds.hpp"
#include "tools/trade/cpu_time.hpp"

// Many bodies that do not interact, under gravity, at a step of 1 ms: millions of steps of one body
// in a second of processor time. States are read at every step, or at every tenth as by a node that
// publishes at 100 Hz.

namespace rigid_body_sim {
namespace {

test::Bench thrownBodies(std::size_t count, bool pushed) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  Draw draw(1);
  for (std::size_t i = 0; i < count; ++i) {
    Body body = draw.box(1);
    body.name += std::to_string(i);
    bench.initial.bodies.push_back(draw.state(body, 5));
    bench.world.bodies.push_back(body);
    if (!pushed) continue;
    PointWrench push;
    push.body = push.point_frame = i;
    push.force = draw.vector(1);
    push.point = draw.vector(0.1);
    push.end = std::numeric_limits<double>::infinity();
    bench.world.wrenches.push_back(push);
  }
  return bench;
}

struct Setting {
  const char* integrator;
  bool pushed;    // each body by a force in world axes at a point of its own
  int read_each;  // steps
};

double millionsPerSecond(const Setting& setting, std::size_t count) {
  constexpr int kSteps = 100;
  const Simulation start = thrownBodies(count, setting.pushed).simulation(setting.integrator, 1e-3);
  const double seconds = leastCpuTime(
      start,
      [&](Simulation& simulation) {
        for (int i = 1; i <= kSteps; ++i) {
          simulation.step();
          if (i % setting.read_each == 0) simulation.state();
        }
      },
      1);
  return 1e-6 * kSteps * static_cast<double>(count) / seconds;
}

void printTable() {
  constexpr std::size_t kCounts[] = {1, 100, 10000};
  std::printf("%-22s %-8s %-12s", "integrator", "pushed", "read each");
  for (std::size_t count : kCounts) std::printf(" %9zu", count);
  std::printf("\n");
  for (const Setting& setting :
       {Setting{"auto", false, 10}, Setting{"auto", false, 1}, Setting{"auto", true, 10},
        Setting{"auto", true, 1}, Setting{"semi_implicit_euler", false, 1},
        Setting{"strang", false, 1}, Setting{"rk4", false, 1}}) {
    std::printf("%-22s %-8s %-12d", setting.integrator, setting.pushed ? "yes" : "no",
                setting.read_each);
    for (std::size_t count : kCounts) std::printf(" %9.3g", millionsPerSecond(setting, count));
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace rigid_body_sim

int main() { rigid_body_sim::printTable(); }
