#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "support/law_benches.hpp"
#include "support/worlds.hpp"

/// Run by scripts/test under the thread sanitizer, too.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::principalBody;
using test::tumbling;

// Each copy is another thread's own, and one that nobody changes is read by both.
TEST(Simulation, CopiesRunInThreadsOfTheirOwn) {
  Bench bench = test::springPair(1);
  bench.add(principalBody("free", 2, {1, 2, 2.5}), tumbling({0, 0, 0}, {0.5, 1, 0.2}));
  PointWrench push;
  push.body = 2;
  push.force = {1, 2, 3};
  push.point = {0.1, 0.2, 0.3};
  bench.world.wrenches = {push};
  bench.world.solver.horizon = 1;
  Simulation start = bench.simulation("auto", 0.01);
  for (int i = 0; i < 5; ++i) start.step();
  const Simulation shared = start;
  std::vector<Simulation> copies(2, start);
  std::vector<Vector3d> read(2);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 2; ++k)
    threads.emplace_back([&, k] {
      copies[k].trackError();
      copies[k].trackBalance();
      for (int i = 0; i < 100; ++i) {
        copies[k].step();
        read[k] =
            shared.body(2).x_W + shared.state().bodies[0].x_W + shared.sample(0.053).bodies[1].x_W;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(copies[0].body(0).x_W, copies[1].body(0).x_W);
  EXPECT_EQ(copies[0].body(2).q_WP.coeffs(), copies[1].body(2).q_WP.coeffs());
  EXPECT_EQ(read[0], read[1]);
}

}  // namespace
}  // namespace rigid_body_sim
