#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/random_bodies.hpp"
#include "support/worlds.hpp"

/// A motion that is solved is evaluated where somebody reads the state, and nobody can tell.
namespace rigid_body_sim {
namespace {

using test::Bench;

constexpr double kReadStep = 0.01;

PointWrench drawWrench(Draw& draw, std::size_t body, double now) {
  PointWrench push;
  push.body = push.point_frame = body;
  push.axes = draw.uniform(0, 1) < 0.5 ? kWorld : body;
  push.force = draw.vector(2);
  push.point = draw.vector(0.3);
  push.start = now + draw.uniform(0, 0.3);
  push.end = push.start + draw.uniform(0, 0.3);
  return push;
}

/// A free body, one under a lasting lever, one with drag, two on a spring; wrenches of the scene on
/// the first two.
Bench everyKindOfBody() {
  Bench bench;
  Draw draw(3);
  bench.world.g_W = {0, 0, -9.81};
  for (const char* name : {"free", "pushed", "dragged", "upper", "lower"})
    bench.add(test::principalBody(name, 2, {1, 2, 2.5}),
              test::tumbling(draw.vector(1), draw.vector(5), draw.attitude()));
  bench.addDrag(2, {0.1, 0, 0.1});
  bench.addSpring({3, draw.vector(0.2)}, {4, draw.vector(0.2)}, {10, 0, 0.5});
  for (int k = 0; k < 20; ++k)
    bench.world.wrenches.push_back(drawWrench(draw, k % 2, draw.uniform(0, 3)));
  PointWrench lever = drawWrench(draw, 1, 0);
  lever.axes = kWorld;
  lever.end = std::numeric_limits<double>::infinity();
  bench.world.wrenches.push_back(lever);
  return bench;
}

/// What may happen to a simulation from outside before a step; the same seed brings the same.
void disturb(Draw& draw, Simulation& sim) {
  const auto body = static_cast<std::size_t>(draw.uniform(0, 5));
  const double what = draw.uniform(0, 1);
  if (what < 0.05) sim.applyWrench("held", drawWrench(draw, body, sim.time()));
  if (what > 0.05 && what < 0.07) sim.clearWrenches(body, "held");
  if (what > 0.07 && what < 0.09)
    sim.setState(body, draw.state(sim.world().bodies[body], draw.uniform(0, 5)));
  if (what > 0.09 && what < 0.092) sim.reset(false);
  if (what > 0.1 && what < 0.11) sim.trackBalance();
  if (what > 0.11 && what < 0.12) sim.trackError();
  if (what > 0.12 && what < 0.14) sim.stopTracking();
  if (what > 0.14 && what < 0.15) sim.sample(sim.time() + draw.uniform(0, kReadStep));
}

void expectSameBits(const State& a, const State& b, const std::string& at) {
  ASSERT_EQ(a.t, b.t) << at;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const BodyState &x = a.bodies[i], &y = b.bodies[i];
    EXPECT_EQ(x.x_W, y.x_W) << at << ", body " << i;
    EXPECT_EQ(x.x_low_W, y.x_low_W) << at << ", body " << i;
    EXPECT_EQ(x.q_WP.coeffs(), y.q_WP.coeffs()) << at << ", body " << i;
    EXPECT_EQ(x.p_W, y.p_W) << at << ", body " << i;
    EXPECT_EQ(x.L_W, y.L_W) << at << ", body " << i;
    EXPECT_EQ(x.L_P, y.L_P) << at << ", body " << i;
  }
}

TEST(SolvedAhead, HasTheSameBitsHoweverOftenItIsRead) {
  const Bench bench = everyKindOfBody();
  for (unsigned seed = 0; seed < 6; ++seed) {
    Simulation read = bench.simulation("auto", kReadStep), unread = read, seldom_read = read;
    Draw for_read(seed), for_unread(seed), for_seldom(seed);
    for (int i = 0; i < 300; ++i) {
      disturb(for_read, read);
      disturb(for_unread, unread);
      disturb(for_seldom, seldom_read);
      for (Simulation* sim : {&read, &unread, &seldom_read}) sim->step();
      const State& state = read.state();
      if (i % 7 == 0)
        expectSameBits(seldom_read.state(), state,
                       "seed " + std::to_string(seed) + ", step " + std::to_string(i));
    }
    expectSameBits(unread.state(), read.state(), "seed " + std::to_string(seed) + ", the end");
  }
}

TEST(SolvedAhead, EndsWhereItsStateWouldNotBeFiniteWhetherReadOrNot) {
  Bench fast, spinning;
  fast.add(test::principalBody("box", 1, {1, 2, 2.5}), test::tumbling({3e307, 0, 0}, {1, 2, 3}));
  spinning.add(test::principalBody("box", 1, {1, 2, 2.5}), test::tumbling({1, 0, 0}, {0, 3e14, 0}));
  for (const Bench& bench : {fast, spinning}) {
    std::vector<std::string> messages;
    std::vector<State> last;
    for (const bool reads : {true, false}) {
      Simulation sim = bench.simulation("auto", 1);
      try {
        for (int i = 0; i < 100; ++i) {
          sim.step();
          if (reads) sim.state();
        }
        FAIL() << "went on";
      } catch (const SimulationDiverged& diverged) {
        messages.push_back(diverged.what());
      }
      last.push_back(sim.state());
    }
    EXPECT_EQ(messages[0], messages[1]);
    expectSameBits(last[0], last[1], messages[0]);
    EXPECT_TRUE(last[0].bodies[0].x_W.allFinite());
    EXPECT_TRUE(last[0].bodies[0].q_WP.coeffs().allFinite());
  }
}

}  // namespace
}  // namespace rigid_body_sim
