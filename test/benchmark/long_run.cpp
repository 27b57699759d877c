#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "dynamics/methods/catalogue.hpp"
#include "support/worlds.hpp"
#include "tools/trade/cpu_time.hpp"

// Where the integrators for conservative motion earn their place: the energy error against the
// processor time that it takes, for a body that swings on a spring, and for one held in a net of 64
// springs, where evaluations are costly. An integrator is tried at ever shorter steps, until they
// no longer gain; `*` marks what no other setting reaches in as little time.

namespace rigid_body_sim {
namespace {

struct Measured {
  std::string integrator;
  double step;     // [s]
  double error;    // of energy, relative to the kinetic energy at the start
  double seconds;  // of processor time
};

test::Bench swingingBody() {
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(test::principalBody("body", 1, {0.02, 0.03, 0.04}),
            test::tumbling({0.3, 0.5, 0}, {1, 2, 0.5}));
  bench.addSpring({0, {0, 0, 0.1}}, {kWorld, {0, 0, 1}}, {40, 0, 0.6});
  return bench;
}

/// Springs from points on the body's surface to points around it.
test::Bench bodyInANet() {
  test::Bench bench;
  bench.add(test::principalBody("body", 2, {0.03, 0.04, 0.05}),
            test::tumbling({0.3, 0.2, -0.1}, {1, -2, 1.5}));
  constexpr int kSprings = 64;
  for (int i = 0; i < kSprings; ++i) {
    const double z = (2 * i + 1.0) / kSprings - 1, angle = 2.4 * i;  // a Fibonacci sphere
    const double r = std::sqrt(1 - z * z);
    const Vector3d direction(r * std::cos(angle), r * std::sin(angle), z);
    bench.addSpring({0, 0.2 * direction}, {kWorld, 1.5 * direction}, {2, 0, 0.8});
  }
  return bench;
}

/// The greatest error of energy, relative to the kinetic energy at the start.
Measured energyRun(const test::Bench& bench, const char* integrator, double duration, double step) {
  Simulation simulation = bench.simulation(integrator, step);
  const double E_0 = mechanicalEnergy(bench.world, bench.initial);
  const double T_0 = kineticEnergy(bench.world.bodies[0], bench.initial.bodies[0]);
  const auto steps = static_cast<std::int64_t>(duration / step);
  double worst = 0, seconds = 0;
  constexpr int kLooks = 200;
  for (int look = 1; look <= kLooks; ++look) {
    const double begin = cpuTime();
    while (simulation.steps() < look * steps / kLooks) simulation.step();
    seconds += cpuTime() - begin;
    worst =
        std::max(worst, std::abs(mechanicalEnergy(bench.world, simulation.state()) - E_0) / T_0);
  }
  return {integrator, step, worst, seconds};
}

/// Every integrator at steps from the longest on, each 0.7 of the one before.
void compare(const char* title, const test::Bench& bench, double duration, double longest) {
  constexpr double kLeastError = 1e-13, kLongestRun = 4;  // [1], [s]
  std::vector<Measured> all;
  for (const Method& method : catalogue()) {
    if (!method.supports(kCoupling)) continue;
    double best = 1;
    int worse = 0;
    for (double step = longest; worse < 3 && best > kLeastError; step *= 0.7) {
      try {
        all.push_back(energyRun(bench, method.name, duration, step));
      } catch (const SimulationDiverged&) {
        continue;
      }
      if (all.back().seconds > kLongestRun) break;
      worse = all.back().error < best ? 0 : worse + 1;
      best = std::min(best, all.back().error);
    }
  }
  std::printf("\n%s\n%-20s %10s %10s %12s\n", title, "integrator", "step [s]", "error",
              "time [ms]");
  for (const Measured& m : all) {
    const bool front = std::none_of(all.begin(), all.end(), [&](const Measured& other) {
      return other.error <= m.error && other.seconds < m.seconds;
    });
    std::printf("%-20s %10.3g %10.1e %12.2f %s\n", m.integrator.c_str(), m.step, m.error,
                1e3 * m.seconds, front ? "*" : "");
  }
}

void compareIntegrators() {
  constexpr double kLong = 1000, kShort = 100;  // [s]
  compare("a body that swings on a spring for 1000 s", swingingBody(), kLong, 0.08);
  compare("a body in a net of 64 springs for 100 s", bodyInANet(), kShort, 0.2);
}

}  // namespace
}  // namespace rigid_body_sim

int main() { rigid_body_sim::compareIntegrators(); }
