#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#include "support/random_bodies.hpp"
#include "support/worlds.hpp"
#include "tools/trade/cpu_time.hpp"

// Many bodies that do not interact, under gravity, at a step of 1 ms: millions of steps of one body
// in a second of processor time. All bodies are read at every step, or at every tenth as by a node
// that publishes at 100 Hz. A number as argument: so many bodies more, which are read at every
// hundredth step.

namespace rigid_body_sim {
namespace {

/// What acts beside gravity.
enum class Load { kNone, kPush, kDrag };

/// kPush: a force in world axes at a point of each body; kDrag: drag of every kind.
test::Bench manyBodies(std::size_t count, Load load) {
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  Draw draw(1);
  for (std::size_t i = 0; i < count; ++i) {
    Body body = draw.box(1);
    body.name += std::to_string(i);
    bench.initial.bodies.push_back(draw.state(body, 5));
    bench.world.bodies.push_back(body);
    if (load == Load::kDrag) bench.addDrag(i, {0.1, 0.1, 0.01});
    if (load != Load::kPush) continue;
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
  Load load;
  int read_each;  // steps
};

double millionsPerSecond(const Setting& setting, std::size_t count, int steps, double budget) {
  Simulation start = manyBodies(count, setting.load).simulation(setting.integrator, 1e-3);
  std::vector<BodyState> states;
  start.step();  // what happens once is not counted
  const double seconds = leastCpuTime(
      start,
      [&](Simulation& simulation) {
        for (int i = 0; i < steps; i += setting.read_each) {
          simulation.step(setting.read_each);
          simulation.readBodies(states);
        }
      },
      budget);
  return 1e-6 * steps * static_cast<double>(count) / seconds;
}

void printTable() {
  constexpr std::size_t kCounts[] = {1, 8, 100, 10000};
  constexpr int kSteps = 100;
  std::printf("%-22s %-8s %-12s", "integrator", "load", "read each");
  for (std::size_t count : kCounts) std::printf(" %9zu", count);
  std::printf("\n");
  for (const auto& [load, name] : {std::pair(Load::kNone, "none"), std::pair(Load::kPush, "push"),
                                   std::pair(Load::kDrag, "drag")})
    for (const char* integrator : {"auto", "semi_implicit_euler", "strang", "magnus4", "rk4"})
      for (int read_each : {10, 1}) {
        if (load == Load::kDrag && std::string(integrator) == "auto") continue;
        std::printf("%-22s %-8s %-12d", integrator, name, read_each);
        for (std::size_t count : kCounts)
          std::printf(" %9.3g", millionsPerSecond({integrator, load, read_each}, count, kSteps, 1));
        std::printf("\n");
        std::fflush(stdout);
      }
}

void printRow(std::size_t count) {
  std::printf("%zu bodies, read at every 100th step\n", count);
  for (const char* integrator : {"semi_implicit_euler", "strang", "magnus4", "rk4"})
    std::printf("%-22s %9.3g\n", integrator,
                millionsPerSecond({integrator, Load::kNone, 100}, count, 200, 0));
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  if (argc > 1) {
    rigid_body_sim::printRow(static_cast<std::size_t>(std::atoll(argv[1])));
    return 0;
  }
  rigid_body_sim::printTable();
}
