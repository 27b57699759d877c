#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <getopt.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "dynamics/run/solved_run.hpp"
#include "support/same_bits.hpp"
#include "tools/common/state_at.hpp"
#include "tools/sweep/solved_step.hpp"
#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_options.hpp"
#include "tools/sweep/sweep_pool.hpp"

/// Parts of `sweep`, without the program.
namespace rigid_body_sim {
namespace {

/// Of pushed balls of many masses.
SweepInputs inputsOfRuns(int runs) {
  SweepInputs inputs;
  inputs.study =
      parseStudy("runs: " + std::to_string(runs) + "\nvary: {bodies.ball.mass: {uniform: [1, 2]}}",
                 "study.yaml");
  inputs.scene_text = test::kPushedBall;
  inputs.context.source = "scene.yaml";
  return inputs;
}

/// They refer to the inputs.
std::vector<std::unique_ptr<SweepRunner>> runnersOf(const SweepInputs& inputs, int count) {
  std::vector<std::unique_ptr<SweepRunner>> runners;
  for (int i = 0; i < count; ++i) runners.push_back(std::make_unique<SweepRunner>(inputs));
  return runners;
}

}  // namespace

TEST(SweepOptions, HaveAThreadForEachCoreThatTheProcessMayUse) {
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  CPU_ZERO(&one);
  for (std::size_t cpu = 0; CPU_COUNT(&one) == 0; ++cpu)
    if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
  const auto threads = [] {
    std::string words[] = {"sweep", "scene.yaml", "study.yaml"};
    char* argv[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    optind = 0;  // of a parser that was used before
    return parseSweepOptions(3, argv, [](const char*) { return nullptr; }).threads;
  };
  EXPECT_EQ(threads(), CPU_COUNT(&all));
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(threads(), 1);
  ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
}

TEST(SweepPool, WritesNothingAfterAWriteThatFailed) {
  const SweepInputs inputs = inputsOfRuns(5000);
  auto runners = runnersOf(inputs, 8);
  const std::atomic<bool> stop{false};
  for (int attempt = 0; attempt < 20; ++attempt) {
    int writes = 0;
    const auto write = [&](const MadeRuns&) {
      ++writes;
      // as slow as a full disk: the other threads come to wait for their turn
      const auto begin = std::chrono::steady_clock::now();
      while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(5)) {
      }
      throw std::runtime_error("the disk is full");
    };
    SweepPool pool(runners, Shard{}, write, stop);
    EXPECT_THROW(pool.run(0, 5000, [](std::int64_t) {}), std::runtime_error);
    ASSERT_EQ(writes, 1) << attempt;
  }
}

// While other threads are at work, which must be waited for.
TEST(SweepPool, ThrowsWhatItsProgressThrows) {
  const SweepInputs inputs = inputsOfRuns(5000000);
  auto runners = runnersOf(inputs, 3);
  const std::atomic<bool> stop{false};
  SweepPool pool(
      runners, Shard{}, [](const MadeRuns&) {}, stop);
  EXPECT_THROW(
      pool.run(0, 5000000, [](std::int64_t) { throw std::runtime_error("the disk is full"); }),
      std::runtime_error);
}

// A step of 0.01 s against one of the whole 20 s, both by series to the same tolerance.
TEST(QuickSimulation, TakesOneStepOfBodiesInAir) {
  const Scene scene = parseScene(R"(gravity: [0, 0, -9.8]
time_step: 0.01
medium: {density: 1.2, velocity: [3, 1, 0]}
bodies:
  - name: box
    shape: {box: [1.0, 0.5, 0.25]}
    mass: 2
    twist: {frame: world, linear: [1, 2, 3], angular: [0.2, 1.5, 0.4]}
    drag: {linear: 0.1, quadratic: 0.05, angular: 0.02}
wrenches:
  - {body: box, frame: world, point: [0.1, 0, 0], force: [0, 0, 1], start: 0.505, duration: 1.255}
)",
                                 "scene.yaml");
  const World world = buildWorld(scene);
  const State initial = initialState(scene, world);
  Simulation quick = quickSimulation(world, initial, 20), stepped(world, initial);
  ASSERT_TRUE(staysSolved(stepped));
  EXPECT_EQ(quick.world().solver.time_step, 20);
  const BodyState a = stateAt(quick, 20).bodies[0], b = stateAt(stepped, 20).bodies[0];
  EXPECT_EQ(quick.steps(), 1);
  EXPECT_LT((a.x_W - b.x_W).norm(), 1e-8);
  EXPECT_LT((a.p_W - b.p_W).norm(), 1e-8);
  EXPECT_LT(a.q_WP.angularDistance(b.q_WP), 1e-8);
}

// The point of the wrench turns, its force's axes do not: an integrator takes over.
TEST(QuickSimulation, KeepsTheTimeStepOfWrenchesThatAreNotHeld) {
  const Scene scene = parseScene(R"(time_step: 0.01
bodies:
  - {name: box, shape: {box: [1.0, 0.5, 0.25]}, mass: 2}
wrenches:
  - {body: box, frame: box, point_frame: world, point: [1, 0, 0], force: [0, 0, 1], start: 0.5, duration: 1}
)",
                                 "scene.yaml");
  const World world = buildWorld(scene);
  const Simulation quick = quickSimulation(world, initialState(scene, world), 2);
  EXPECT_EQ(quick.world().solver.time_step, 0.01);
}

// Wrenches that start before, at and after the ends of others, on a pivot and with a tolerance,
// too.
// but in free flight of a body of three different moments, which is solved in another way
TEST(SolvedRun, HasTheBitsOfASimulation) {
  const std::string text = R"(gravity: [0, 0, -9.8]
time_step: 0.01
bodies:
  - {name: box, shape: {box: [1.0, 0.5, 0.25]}, mass: 2, twist: {frame: world, linear: [1, 2, 3], angular: [0.2, 1.5, 0.4]}}
  - {name: rock, shape: {sphere: {radius: 1}}, mass: 1, fixed: true, position: [5, 0, 0]}
  - {name: guest, shape: {sphere: {radius: 1}}, mass: 1, absent: true}
  - {name: top, shape: {cylinder: {radius: 0.3, length: 0.1}}, mass: 2, pivot: {point: [0, 0, -0.5]}, twist: {frame: body, angular: [0.5, 0, 20]}}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 0.5, position: [0, 3, 0]}
wrenches:
  - {body: box, frame: box, point: [0.5, 0.25, 0], force: [0, 0, -1.5], start: 0.5, duration: 1}
  - {body: box, frame: world, point: [-0.5, 0, 0.1], force: [0.8, -0.4, 0], start: 0, duration: 0.7}
  - {body: box, frame: world, point_frame: world, point: [0, 0, 1], force: [0.1, 0, 0], start: 1.5, duration: .inf}
  - {body: top, frame: world, torque: [0.1, 0, 0], start: 0.3, duration: 0.4}
  - {body: ball, frame: world, force: [1, 0, 0], start: 2, duration: 9}
)";
  for (const char* more : {"", "tolerance: 1e-4\n"}) {
    const Scene scene = parseScene(more + text, "scene.yaml");
    const World world = buildWorld(scene);
    const State initial = initialState(scene, world);
    ASSERT_TRUE(isSolvedThroughout(world));
    for (const double duration : {0.4, 1.5, 2.0, 3.3}) {
      const std::vector<BodyState> end = solvedAfter(world, initial, duration);
      Simulation run = quickSimulation(world, initial, duration);
      const std::vector<BodyState> same = stateAt(run, duration).bodies;
      ASSERT_EQ(end.size(), same.size());
      for (std::size_t i = 0; i < end.size(); ++i)
        EXPECT_TRUE(test::sameBits(end[i], same[i])) << more << duration << " s, body " << i;
    }
  }
}

TEST(SolvedRun, HasFreeFlightsOfASimulationToRounding) {
  const Scene scene = parseScene(
      "time_step: 0.01\ngravity: [0, 0, -9.81]\nbodies: [{name: box, shape: {box: [1, 0.5, 0.25]}, "
      "mass: 2, twist: {frame: world, linear: [1, 0.5, 12], angular: [0.2, 1.5, 0.4]}}]\nwrenches: "
      "[{body: box, frame: box, point: [0.5, 0.25, 0], force: [0, 0, -1.5], start: 0.5, duration: "
      "1}]\n",
      "scene.yaml");
  const World world = buildWorld(scene);
  const State initial = initialState(scene, world);
  for (const double duration : {0.4, 1.2, 4.0}) {
    const BodyState end = solvedAfter(world, initial, duration).front();
    Simulation run = quickSimulation(world, initial, duration);
    const BodyState other = stateAt(run, duration).bodies.front();
    // turned by some 10 rad, each of which may cost both a few units of the last digit
    constexpr double kRounding = 2e-14;
    EXPECT_LT((end.q_WP.coeffs() - other.q_WP.coeffs()).norm(), kRounding) << duration;
    EXPECT_LT((end.L_P - other.L_P).norm(), kRounding * other.L_P.norm()) << duration;
    EXPECT_LT((end.L_W - other.L_W).norm(), kRounding * other.L_W.norm()) << duration;
    EXPECT_LT((end.x_W - other.x_W).norm(), kRounding * 50) << duration;
  }
}

TEST(SolvedRun, RefusesAndDivergesAsASimulation) {
  const auto world_of = [](const std::string& wrench) {
    const Scene scene = parseScene(
        "time_step: 0.5\nbodies: [{name: rocket, shape: {sphere: "
        "{radius: 1}}, mass: 1.0e-300}]\nwrenches: [" +
            wrench + "]\n",
        "scene.yaml");
    World world = buildWorld(scene);
    State initial = initialState(scene, world);
    return std::make_pair(std::move(world), std::move(initial));
  };
  const auto [world, initial] =
      world_of("{body: rocket, frame: world, force: [1.0e300, 0, 0], start: 0, duration: 1000}");
  std::string diverged, refused;
  try {
    Simulation(world, initial).step();
  } catch (const SimulationDiverged& error) {
    diverged = error.what();
  }
  ASSERT_FALSE(diverged.empty());
  try {
    solvedAfter(world, initial, 0.5);
    ADD_FAILURE();
  } catch (const SimulationDiverged& error) {
    EXPECT_EQ(error.what(), diverged);
  }
  World bad = world;
  bad.wrenches[0].force.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solvedAfter(bad, initial, 0.5), std::invalid_argument);
  // neither is solved throughout
  bad = world;
  bad.solver.integrator = "rk4";
  EXPECT_FALSE(isSolvedThroughout(bad));
  bad = world;
  bad.bodies[0].actuators.emplace_back();
  EXPECT_FALSE(isSolvedThroughout(bad));
  EXPECT_FALSE(isSolvedThroughout(
      world_of("{body: rocket, frame: rocket, point_frame: world, force: [1, 0, 0], duration: 1}")
          .first));
}

}  // namespace rigid_body_sim
