#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"
#include "support/refusal.hpp"

/// Bodies that are put below the ground with all of them: one clear line, and no run without end.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;
using test::refusalOf;

/// [m] Where the centre of a ball of 0.1 m is.
Bench ballAt(double height) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  test::addBall(bench, 0.1, 1, motionAt({0, 0, height}), test::slope(0),
                contactOf(1e6, 1.5, 0.2, 0.5));
  return bench;
}

TEST(Buried, IsRefusedAtTheStart) {
  for (const double depth : {1e-3, 1.0, 1e9}) {
    const std::string said = refusalOf([&] { ballAt(-0.1 - depth).simulation("auto", 0.01); });
    EXPECT_EQ(
        said.find("body 'ball0': position must leave some of it above the plane, got its top "), 0u)
        << said;
  }
}

TEST(Buried, IsRefusedOfAStateThatIsSet) {
  Simulation sim = ballAt(0.3).simulation("auto", 0.01);
  BodyState below = sim.body(0);
  below.x_W.z() = -1000;
  EXPECT_NE(refusalOf([&] { sim.setState(0, below); }).find("above the plane, got its top "),
            std::string::npos);
  EXPECT_EQ(sim.body(0).x_W.z(), 0.3);
}

TEST(Buried, IsNoBodyOfWhichAPartIsAbove) {
  Simulation sim = ballAt(-0.0999).simulation("auto", 0.01);
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_GT(sim.body(0).x_W.z(), 0);
}

// By a stiffness far too low for the weight, a body may come to lie there.
TEST(Buried, MayABodyBecomeAndGoOnFromAState) {
  Bench bench = ballAt(0.1);
  bench.world.laws[0] = contactWithHalfSpace(bench.world.bodies, 0, test::ballShape(0.1),
                                             test::slope(0), contactOf(1, 1, 0.2, 0.5));
  Simulation sim = bench.simulation("auto", 0.01);
  while (sim.time() < 1) sim.step();
  EXPECT_LT(sim.body(0).x_W.z(), -1);
  Simulation rest(sim.world(), sim.state());
  rest.step();
  sim.step();
  EXPECT_EQ(rest.body(0).x_W, sim.body(0).x_W);
}

}  // namespace
}  // namespace rigid_body_sim
