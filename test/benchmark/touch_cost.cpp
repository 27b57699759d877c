#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "support/costed_contacts.hpp"
#include "tools/trade/cpu_time.hpp"

// What contact costs and errs by where a step may err by 1e-9, beside what was stated before it was
// built; against steps that may err by 1e-14.

namespace rigid_body_sim {
namespace {

struct Cost {
  State end;
  std::int64_t evaluations;
  double seconds;
};

Cost runCosted(test::CostedContact c, double bound) {
  c.bench.initial.contact_bound = bound;
  Simulation sim = c.bench.simulation("auto", c.duration);
  const double begin = cpuTime();
  sim.step();
  return {sim.state(), sim.evaluations(), cpuTime() - begin};
}

void printCosts(double bound) {
  std::printf("%-28s %6s %9s %9s %11s %9s\n", "scene", "s", "m", "rad", "evaluations", "ms");
  std::vector<test::CostedContact> cases = test::costedContacts();
  cases.push_back(test::stifferRolling());
  for (const test::CostedContact& c : cases) {
    const Cost truth = runCosted(c, 1e-14), cost = runCosted(c, bound);
    double metre = 0, radian = 0;
    for (std::size_t i = 0; i < truth.end.bodies.size(); ++i) {
      const BodyState &a = cost.end.bodies[i], &b = truth.end.bodies[i];
      metre = std::max(metre, distanceBetween(a, b));
      radian = std::max(radian, angleBetween(a.q_WP, b.q_WP));
    }
    std::printf("%-28s %6.1f %9.0e %9.0e %11lld %9.2f\n", c.name.c_str(), c.duration, metre, radian,
                static_cast<long long>(cost.evaluations), 1e3 * cost.seconds);
    std::printf("%-28s %6s %9.0e %9.0e %11.0f    (%d events)\n", "  prototype", "", c.metre,
                c.radian, c.evaluations, c.events);
  }
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  rigid_body_sim::printCosts(argc > 1 ? std::atof(argv[1]) : 1e-9);
}
