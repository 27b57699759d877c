#include <algorithm>
#include <atomic>
#include <mutex>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/packs/in_parts.hpp"
#include "support/packed_integrators.hpp"
#include "support/same_bits.hpp"

/// Run by scripts/test under the thread sanitizer, too, and thus without the library of the tests'
/// support: all of it would be compiled once more.
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

struct Thrown {
  World world;
  State start;
};

/// Under gravity: boxes, and every fifth a body of two or three equal moments.
Thrown thrownBodies(std::size_t count) {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto vector = [&](double size) {
    Vector3d v;
    for (int k = 0; k < 3; ++k) v[k] = uniform(-size, size);
    return v;
  };
  Thrown thrown;
  thrown.world.g_W = {0, 0, -9.81};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d edges{uniform(0.3, 1), uniform(0.3, 1), uniform(0.3, 1)};
    MassProperties properties = massProperties(Box{edges}, uniform(0.5, 5));
    if (i % 5 == 4) {
      const Vector3d moments[]{{1, 1, 1}, {1, 1, 1.5}, {0.5, 1, 1}};
      properties = {1, Vector3d::Zero(), moments[i / 5 % 3].asDiagonal()};
    }
    BodyFrameMotion motion;
    motion.x_W = vector(1);
    motion.q_WB = rotationExp(vector(2));
    motion.v_W = vector(1);
    motion.w_W = vector(5);
    thrown.world.bodies.push_back(makeBody("body" + std::to_string(i), properties));
    thrown.start.bodies.push_back(toBodyState(thrown.world.bodies.back(), motion));
  }
  return thrown;
}

/// All states after so many steps, by so many threads.
std::vector<BodyState> run(Thrown thrown, const std::string& integrator, int threads, int steps) {
  thrown.world.solver.threads = threads;
  thrown.world.solver.integrator = integrator;
  thrown.world.solver.time_step = 0.01;
  Simulation simulation(std::move(thrown.world), thrown.start);
  std::vector<BodyState> states, again;
  simulation.step(steps, states);
  simulation.readBodies(again);
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_TRUE(test::sameBits(states[i], again[i]));
  return states;
}

void expectSameBitsByThreads(const Thrown& thrown, const std::string& integrator, int steps,
                             const std::vector<int>& numbers) {
  const std::vector<BodyState> alone = run(thrown, integrator, 1, steps);
  for (const int threads : numbers) {
    const std::vector<BodyState> parted = run(thrown, integrator, threads, steps);
    ASSERT_EQ(parted.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
      ASSERT_TRUE(test::sameBits(parted[i], alone[i])) << integrator << ", body " << i;
  }
}

// so many body-steps that seven threads are worthwhile
TEST(Threads, StepPacksToTheSameBits) {
  Thrown thrown = thrownBodies(1805);
  PointWrench turn;
  turn.force = {1, -2, 3};
  turn.end = 10;
  turn.torque = {0.1, 0.2, -0.1};
  for (turn.body = 3; turn.body < 100; turn.body += 7) {
    turn.point_frame = turn.body;
    thrown.world.wrenches.push_back(turn);
  }
  for (const std::string& integrator : test::packedIntegrators())
    expectSameBitsByThreads(thrown, integrator, 70, {2, 7});
}

// so many bodies that two threads are worthwhile
TEST(Threads, ReadManyBodiesToTheSameBits) {
  const Thrown thrown = thrownBodies(8203);
  test::expectBodiesReadByTwoThreads(thrown.world, thrown.start, "auto");
}

}  // namespace
}  // namespace rigid_body_sim
