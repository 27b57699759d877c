#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>

/// Run by scripts/test under the thread sanitizer, too, and thus without the library of the tests'
/// support: all of it would be compiled once more.
namespace rigid_body_sim {
namespace {

/// Two bodies on a damped spring between them and a free one, which is pushed; each tumbles.
Simulation pairAndFreeBody() {
  World world;
  State start;
  const auto add = [&](const Vector3d& x_W, const Vector3d& v_W, const Vector3d& w_W, double mass,
                       const Vector3d& I) {
    BodyFrameMotion motion;
    motion.x_W = x_W;
    motion.v_W = v_W;
    motion.w_W = w_W;
    world.bodies.push_back(makeBody("body" + std::to_string(world.bodies.size()),
                                    {mass, Vector3d::Zero(), I.asDiagonal()}));
    start.bodies.push_back(toBodyState(world.bodies.back(), motion));
  };
  add({0, 0, 0}, {0.3, 0, -0.2}, {0.5, -0.7, 0.4}, 2, {0.5, 0.7, 0.9});
  add({0.4, 0.3, -1.6}, {-0.5, 0.3, 0.2}, {-0.3, 0.5, 0.4}, 1, {0.3, 0.2, 0.35});
  add({0, 0, 0}, {0, 0, 0}, {0.5, 1, 0.2}, 2, {1, 2, 2.5});
  world.laws.push_back(std::make_shared<Spring>(Spring::End{0, {0.1, 0.2, -0.3}},
                                                Spring::End{1, {0, -0.2, 0.25}},
                                                Spring::Constants{5, 1, 0.8}));
  PointWrench push;
  push.body = 2;
  push.force = {1, 2, 3};
  push.point = {0.1, 0.2, 0.3};
  world.wrenches = {push};
  world.solver.horizon = 1;
  world.solver.integrator = "auto";
  world.solver.time_step = 0.01;
  return Simulation(world, start);
}

// Each copy is another thread's own, and one that nobody changes is read by both.
TEST(Simulation, CopiesRunInThreadsOfTheirOwn) {
  Simulation start = pairAndFreeBody();
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
