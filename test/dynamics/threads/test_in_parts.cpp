#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/packs/in_parts.hpp"
#include "support/many_bodies.hpp"
#include "support/same_bits.hpp"

/// Run by scripts/test under the thread sanitizer, too.
namespace rigid_body_sim {
namespace {

TEST(Parts, MakeUpTheWholeInUnits) {
  for (const std::size_t items : {0u, 1u, 7u, 8u, 9u, 64u, 1001u})
    for (const std::size_t threads : {0u, 1u, 2u, 3u, 7u, 50u}) {
      std::mutex mutex;
      std::vector<std::pair<std::size_t, std::size_t>> ranges;
      inParts(items, 8, threads, [&](std::size_t first, std::size_t end) {
        const std::lock_guard<std::mutex> lock(mutex);
        ranges.emplace_back(first, end);
      });
      std::sort(ranges.begin(), ranges.end());
      std::size_t at = 0;
      for (const auto& [first, end] : ranges) {
        EXPECT_EQ(first, at);
        EXPECT_EQ(first % 8, 0u);
        at = end;
      }
      EXPECT_EQ(at, items) << threads << " threads";
      EXPECT_EQ(ranges.size(), std::max<std::size_t>(1, std::min(threads, (items + 7) / 8)));
    }
}

TEST(Parts, HaveThreadsOfTheirOwnOfWhichTheCallersIsOne) {
  std::mutex mutex;
  std::vector<std::thread::id> ids;
  inParts(3, 1, 3, [&](std::size_t, std::size_t) {
    const std::lock_guard<std::mutex> lock(mutex);
    ids.push_back(std::this_thread::get_id());
  });
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()) - ids.begin(), 3);
  EXPECT_TRUE(std::binary_search(ids.begin(), ids.end(), std::this_thread::get_id()));
}

TEST(Parts, ThrowWhatTheFirstOfThemThrewWhenAllAreDone) {
  std::atomic<int> done{0};
  try {
    inParts(4, 1, 4, [&](std::size_t first, std::size_t) {
      ++done;
      if (first >= 1) throw std::runtime_error(std::to_string(first));
    });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "1");
  }
  EXPECT_EQ(done, 4);
}

TEST(Parts, AreNoMoreThanTheWorkIsWorth) {
  EXPECT_EQ(worthwhileThreads(4, 0, 100), 1u);
  EXPECT_EQ(worthwhileThreads(4, 199, 100), 1u);
  EXPECT_EQ(worthwhileThreads(4, 200, 100), 2u);
  EXPECT_EQ(worthwhileThreads(4, 1000, 100), 4u);
}

/// All states after so many steps, by so many threads.
std::vector<BodyState> run(test::Bench bench, const std::string& integrator, int threads,
                           int steps) {
  bench.world.solver.threads = threads;
  Simulation simulation = bench.simulation(integrator, 0.01);
  std::vector<BodyState> states, again;
  simulation.step(steps, states);
  simulation.readBodies(again);
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_TRUE(test::sameBits(states[i], again[i]));
  return states;
}

void expectSameBitsByThreads(const test::Bench& bench, const std::string& integrator, int steps,
                             const std::vector<int>& numbers) {
  const std::vector<BodyState> alone = run(bench, integrator, 1, steps);
  for (const int threads : numbers) {
    const std::vector<BodyState> parted = run(bench, integrator, threads, steps);
    ASSERT_EQ(parted.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
      ASSERT_TRUE(test::sameBits(parted[i], alone[i])) << integrator << ", body " << i;
  }
}

// so many body-steps that seven threads are worthwhile
TEST(Threads, StepPacksToTheSameBits) {
  test::Bench bench = test::thrownBodies(1805);
  PointWrench turn = test::worldForce({1, -2, 3}, 0, 10);
  turn.torque = {0.1, 0.2, -0.1};
  for (turn.body = 3; turn.body < 100; turn.body += 7) {
    turn.point_frame = turn.body;
    bench.world.wrenches.push_back(turn);
  }
  for (const std::string& integrator : test::packedIntegrators())
    expectSameBitsByThreads(bench, integrator, 70, {2, 7});
}

// so many bodies that two threads are worthwhile
TEST(Threads, ReadManyBodiesToTheSameBits) {
  test::expectBodiesReadByTwoThreads(test::thrownBodies(8203), "auto");
}

}  // namespace
}  // namespace rigid_body_sim
