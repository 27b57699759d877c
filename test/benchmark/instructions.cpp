#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include "support/law_benches.hpp"

/// Steps one scene a number of times and does nothing else, to be counted by callgrind:
///   instructions SCENE STEPS
/// scripts/count_instructions runs it at two numbers of steps; their difference is free of all that
/// happens once.
namespace rigid_body_sim {
namespace {

using test::Bench;

Body wingNut(std::size_t i) {
  return test::principalBody("body" + std::to_string(i), 1, {1, 2, 3});
}

Bench freeBodies(std::size_t count) {
  Bench bench;
  for (std::size_t i = 0; i < count; ++i)
    bench.add(wingNut(i), test::tumbling({1, 0, 0}, {1, 1.5, 0.5}));
  return bench;
}

/// Under gravity and a force fixed in the world at a point of the body.
Bench leveredBody() {
  Bench bench = freeBodies(1);
  bench.world.g_W = {0, 0, -9.81};
  PointWrench push;
  push.force = {1, 2, 3};
  push.point = {0.1, 0.2, 0.3};
  bench.world.wrenches.push_back(push);
  return bench;
}

Bench chain(std::size_t springs) {
  Bench bench;
  for (std::size_t i = 0; i <= springs; ++i) {
    BodyFrameMotion motion = test::tumbling({0, 0, 0}, {1, 1.5, 0.5});
    motion.x_W = {static_cast<double>(i), 0, 0};
    bench.add(wingNut(i), motion);
    if (i > 0) bench.addSpring({i - 1, {0.1, 0, 0}}, {i, {-0.1, 0, 0}}, {10, 0, 0.8});
  }
  return bench;
}

Bench draggedBody() {
  Bench bench = freeBodies(1);
  bench.addDrag(0, {0.1, 0, 0.1});
  return bench;
}

struct Measured {
  Bench bench;
  const char* integrator;
  bool reads = true;  ///< the state, after every step
};

const std::map<std::string, std::function<Measured()>>& scenes() {
  static const std::map<std::string, std::function<Measured()>> all{
      {"free_auto_1",
       [] {
         return Measured{freeBodies(1), "auto"};
       }},
      {"free_auto_10",
       [] {
         return Measured{freeBodies(10), "auto"};
       }},
      {"free_auto_100",
       [] {
         return Measured{freeBodies(100), "auto"};
       }},
      {"free_unread_auto_100",
       [] {
         return Measured{freeBodies(100), "auto", false};
       }},
      {"lever_auto_1",
       [] {
         return Measured{leveredBody(), "auto"};
       }},
      {"lever_dop853_1",
       [] {
         return Measured{leveredBody(), "dop853"};
       }},
      {"chain_dop853_1",
       [] {
         return Measured{chain(1), "dop853"};
       }},
      {"free_strang_1",
       [] {
         return Measured{freeBodies(1), "strang"};
       }},
      {"free_strang_10",
       [] {
         return Measured{freeBodies(10), "strang"};
       }},
      {"free_strang_100",
       [] {
         return Measured{freeBodies(100), "strang"};
       }},
      {"drag_strang_1",
       [] {
         return Measured{draggedBody(), "strang"};
       }},
      {"chain_strang_1",
       [] {
         return Measured{chain(1), "strang"};
       }},
      {"chain_strang_10",
       [] {
         return Measured{chain(10), "strang"};
       }},
      {"chain_strang_100",
       [] {
         return Measured{chain(100), "strang"};
       }},
      {"chain_strang_1000",
       [] {
         return Measured{chain(1000), "strang"};
       }},
  };
  return all;
}

int run(const std::string& scene, int steps) {
  const auto entry = scenes().find(scene);
  if (entry == scenes().end()) {
    for (const auto& known : scenes()) std::printf("%s\n", known.first.c_str());
    return 2;
  }
  const Measured measured = entry->second();
  Simulation sim = measured.bench.simulation(measured.integrator, 1e-3);
  const std::size_t bodies = sim.world().bodies.size();
  for (int i = 0; i < steps; ++i) {
    sim.step();
    for (std::size_t k = 0; measured.reads && k < bodies; ++k) sim.body(k);
  }
  return 0;
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  return rigid_body_sim::run(argc == 3 ? argv[1] : "", argc == 3 ? std::atoi(argv[2]) : 0);
}
