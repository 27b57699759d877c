#include <algorithm>
#include <chrono>
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
// that publishes at 100 Hz. A number as argument: so many bodies, which are read at every hundredth
// step. A second number: by up to so many threads, read at every tenth step, and in a second of the
// clock, the best of five.

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
  const double seconds = undisturbedCpuTime(
      start,
      [&](Simulation& simulation) {
        for (int i = 0; i < steps; i += setting.read_each) {
          simulation.step(setting.read_each, states);
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

double byThreads(const char* integrator, std::size_t count, int threads) {
  test::Bench bench = manyBodies(count, Load::kNone);
  bench.world.solver.threads = threads;
  Simulation simulation = bench.simulation(integrator, 1e-3);
  std::vector<BodyState> states;
  simulation.step();
  constexpr int kSteps = 100;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 5; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kSteps; i += 10) {
      simulation.step(10, states);
    }
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    least = std::min(least, wall.count());
  }
  return 1e-6 * kSteps * static_cast<double>(count) / least;
}

void printThreads(std::size_t count, int most) {
  std::printf("%zu bodies, read at every 10th step, by threads\n%-22s", count, "integrator");
  for (int threads = 1; threads <= most; ++threads) std::printf(" %9d", threads);
  std::printf("\n");
  for (const char* integrator : {"auto", "semi_implicit_euler", "strang", "magnus4", "rk4"}) {
    std::printf("%-22s", integrator);
    for (int threads = 1; threads <= most; ++threads)
      std::printf(" %9.3g", byThreads(integrator, count, threads));
    std::printf("\n");
  }
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  if (argc == 1) return rigid_body_sim::printTable(), 0;
  const auto bodies = static_cast<std::size_t>(std::atoll(argv[1]));
  if (argc == 2) return rigid_body_sim::printRow(bodies), 0;
  rigid_body_sim::printThreads(bodies, std::atoi(argv[2]));
}
