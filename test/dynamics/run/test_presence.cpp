#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/central_gravity.hpp>
#include <rigid_body_sim/dynamics/line_force.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/motor_benches.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Bodies that come in and leave while the run goes on.
namespace rigid_body_sim {
namespace {

using test::Bench;

constexpr double kPresenceStep = 0.01;

Simulation advanced(Simulation sim, int steps) {
  for (int i = 0; i < steps; ++i) sim.step();
  return sim;
}

/// Three bodies that fly, the second and third on one spring.
Bench threeOfWhichTwoAreLinked() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  for (const char* name : {"a", "b", "c"})
    bench.add(test::principalBody(name, 2, {1, 2, 2.5}),
              test::tumbling({0.1, 0, double(bench.world.bodies.size())}, {0.5, 1, 0.2}));
  bench.addSpring({1, {0.1, 0, 0}}, {2, {0, 0.1, 0}}, {40, 0.1, 0.5});
  return bench;
}

std::string refusalOfPresence(Simulation& sim, std::size_t body,
                              const std::optional<BodyState>& state) {
  return test::refusalThatChangesNothing(sim, [&] { sim.setPresent(body, state); });
}

std::string refusalOfInput(Simulation& sim, const SimulationInput& input) {
  try {
    sim.apply(input);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

Simulation withoutBody(const Bench& bench, std::size_t body) {
  Bench fewer = bench;
  fewer.world.bodies[body].absent = true;
  return fewer.simulation("auto", kPresenceStep);
}

}  // namespace

TEST(Presence, ABodyThatIsAbsentFromTheStartActsOnNothing) {
  Simulation sim = advanced(withoutBody(threeOfWhichTwoAreLinked(), 2), 20);
  Bench alone;
  alone.world.g_W = {0, 0, -9.81};
  alone.add(test::principalBody("b", 2, {1, 2, 2.5}), test::tumbling({0.1, 0, 1}, {0.5, 1, 0.2}));
  const Simulation expected = advanced(alone.simulation("auto", kPresenceStep), 20);
  test::expectSameBodyState(sim.body(1), expected.body(0));
  EXPECT_EQ(sim.plans().size(), 2U);
  EXPECT_LT(std::abs(totalsOf(sim.world(), sim.state()).momentum.x() - 0.4), 1e-14);
}

TEST(Presence, ABodyThatComesInMovesAsOneThatHadBeenThere) {
  const Bench bench = threeOfWhichTwoAreLinked();
  const Simulation all = bench.simulation("dop853", kPresenceStep);
  Bench fewer = bench;
  fewer.world.bodies[2].absent = true;
  Simulation sim = fewer.simulation("dop853", kPresenceStep);
  sim.setPresent(2, all.body(2));
  sim = advanced(sim, 50);
  const Simulation expected = advanced(all, 50);
  for (std::size_t i : {0U, 1U, 2U}) {
    EXPECT_LT(distanceBetween(sim.body(i), expected.body(i)), 1e-12);
    EXPECT_LT(angleBetween(sim.body(i).q_WP, expected.body(i).q_WP), 1e-12);
  }
}

TEST(Presence, ABodyThatLeavesLeavesOthersTheirBits) {
  Simulation stays = advanced(threeOfWhichTwoAreLinked().simulation("auto", kPresenceStep), 20);
  Simulation leaves = stays;
  leaves.setPresent(2, std::nullopt);
  const BodyState at_once = leaves.body(1);
  test::expectSameBodyState(at_once, stays.body(1));
  stays = advanced(stays, 20);
  leaves = advanced(leaves, 20);
  test::expectSameBodyState(leaves.body(0), stays.body(0));
  // the other end of the spring falls freely from there on
  const Vector3d fallen = at_once.p_W + 2 * 0.2 * Vector3d(0, 0, -9.81);
  EXPECT_LT((leaves.body(1).p_W - fallen).norm(), 1e-13);
  EXPECT_EQ(leaves.plans().size(), 2U);
}

TEST(Presence, IsBookedAndTheBalanceStillCloses) {
  for (const char* integrator : {"auto", "dop853"}) {
    Simulation sim = threeOfWhichTwoAreLinked().simulation(integrator, kPresenceStep);
    sim.trackBalance();
    sim = advanced(sim, 10);
    const BodyState state = sim.body(2);
    sim.setPresent(2, std::nullopt);
    sim = advanced(sim, 10);
    sim.setPresent(2, state);
    sim = advanced(sim, 10);
    EXPECT_LT(std::abs(sim.balance().energy), 1e-7);
    EXPECT_LT(sim.balance().momentum.norm(), 1e-8);
    EXPECT_LT(sim.balance().angular_momentum.norm(), 1e-8);
  }
}

TEST(Presence, EndsWithAReset) {
  Simulation sim = threeOfWhichTwoAreLinked().simulation("auto", kPresenceStep);
  const State start = sim.state();
  sim = advanced(sim, 5);
  sim.setPresent(1, std::nullopt);
  sim.reset(true);
  test::expectSameState(sim.state(), start);
}

TEST(Presence, GoesOnWithTheSameBitsFromAState) {
  for (const Bench& bench : {threeOfWhichTwoAreLinked(), test::stackedBalls(0.02, 0)}) {
    const Simulation start = bench.simulation("auto", kPresenceStep);
    Simulation whole = advanced(start, 20);
    const BodyState back = whole.body(1);
    whole.setPresent(1, std::nullopt);
    whole = advanced(whole, 10);
    Simulation left = start;
    left.load(whole.state());
    test::expectSameState(left.state(), whole.state());
    whole.setPresent(1, back);
    left.setPresent(1, back);
    test::expectSameState(left.state(), whole.state());
    whole = advanced(whole, 10);
    Simulation entered = start;
    entered.load(whole.state());
    whole = advanced(whole, 30);
    test::expectSameState(advanced(left, 40).state(), whole.state());
    test::expectSameState(advanced(entered, 30).state(), whole.state());
  }
}

TEST(Presence, ABodyThatComesInTouchesWhatIsThere) {
  Bench bench = test::stackedBalls(0.02, 0);
  bench.world.bodies[1].absent = true;
  Simulation sim = advanced(bench.simulation("auto", kPresenceStep), 200);
  sim.setPresent(1, toBodyState(bench.world.bodies[1], test::motionAt({0, 0, 0.5})));
  sim = advanced(sim, 100);
  EXPECT_GT(sim.body(1).x_W.z(), 0.05);  // on the ground or on the other ball
  EXPECT_LT(sim.body(1).x_W.z(), 0.4);
}

/// A body that falls through air, solved, and one that is absent, on a tether to it or to the
/// world.
Bench faller(bool tied) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(test::principalBody("faller", 2, {1, 2, 2.5}), test::tumbling({0.1, 0, 0}, {0, 1, 0}));
  bench.add(test::principalBody("guest", 1, {1, 1, 1}), test::motionAt({0, 0, 0}));
  bench.world.bodies[1].absent = true;
  MediumDrag::Coefficients drag;
  drag.linear.alike = 0.3;
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, Vector3d(3, 0, 0)));
  const Spring::End other{tied ? 0 : kWorld, {0, 0, 0}};
  bench.world.laws.push_back(
      std::make_shared<Tether>(other, Spring::End{1, {0, 0, 0}}, Tether::Constants{100, 0, 1}));
  return bench;
}

TEST(Presence, OfAWatchedBodyLeavesTheBitsOfOneInAir) {
  const Simulation start = advanced(faller(false).simulation("auto", kPresenceStep), 20);
  Simulation entered = start;
  entered.setPresent(1, toBodyState(start.world().bodies[1], test::motionAt({0, 0, 0.5})));
  ASSERT_EQ(entered.plans().size(), 2u);
  EXPECT_EQ(entered.plans()[0].integrator, "");
  const BodyState with = advanced(entered, 100).body(0), without = advanced(start, 100).body(0);
  test::expectSameBodyState(with, without);
}

TEST(Presence, OfABodyOnATetherEndsThatTheOtherIsSolvedInAir) {
  const Bench bench = faller(true);
  const auto run = [&](const std::string& integrator, int parts) {
    Simulation sim = advanced(bench.simulation(integrator, kPresenceStep / parts), 20 * parts);
    EXPECT_EQ(sim.plans()[0].integrator.empty(), integrator == "auto");
    const Vector3d below = sim.body(0).x_W - Vector3d(0, 0, 0.5);
    sim.setPresent(1, toBodyState(bench.world.bodies[1], test::motionAt(below)));
    EXPECT_FALSE(sim.plans()[0].integrator.empty());
    return advanced(sim, 100 * parts);
  };
  const Simulation sim = run("auto", 1), fine = run("dop853", 10);
  EXPECT_GT(std::abs(lineForcesOf(fine.world(), fine.state())[0].tension), 1);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT(distanceBetween(sim.body(i), fine.body(i)), 1e-9) << i;  // the tolerance
}

TEST(Presence, MotorsStartAnewWhereTheirBodyComesIn) {
  const Bench bench = test::benchOf(test::motley(), test::motleyStart());
  const Simulation start = bench.simulation("auto", kPresenceStep);
  Simulation sim = advanced(start, 30);
  sim.setPresent(0, std::nullopt);
  sim = advanced(sim, 10);
  sim.setPresent(0, bench.initial.bodies[0]);
  const State entered = sim.state(), at_start = start.state();
  for (std::size_t k = 0; k < entered.actuators[0].size(); ++k) {
    EXPECT_EQ(entered.actuators[0][k].value, at_start.actuators[0][k].value);
    EXPECT_EQ(entered.actuators[0][k].since, sim.time());
  }
  test::expectSameBodyState(entered.bodies[0], at_start.bodies[0]);
}

TEST(Presence, WrenchesEndWithTheBodyThatTheyActOnOrTurnWith) {
  Simulation sim = threeOfWhichTwoAreLinked().simulation("auto", kPresenceStep);
  PointWrench push;
  push.body = 2;
  push.force = {1, 0, 0};
  sim.applyWrench("own", push);
  push.body = 0;
  sim.applyWrench("stays", push);
  push.axes = 2;
  sim.applyWrench("turns with it", push);
  sim = advanced(sim, 3);
  sim.setPresent(2, std::nullopt);
  EXPECT_EQ(sim.wrenchCount(), 1U);
  EXPECT_NE(refusalOfInput(sim, WrenchInput{"", push}).find("absent"), std::string::npos);
  push.axes = kWorld;
  push.body = 2;
  EXPECT_EQ(refusalOfInput(sim, WrenchInput{"", push}),
            "body 'c' is absent, nothing acts on it until it comes in");
  EXPECT_NE(refusalOfInput(sim, StateInput{2, {}}), "");
  advanced(sim, 3);
}

TEST(Presence, IsRefusedInOneLineWhereItIsSoAlready) {
  Bench bench = threeOfWhichTwoAreLinked();
  bench.world.bodies.push_back(test::principalBody("post", 1, {1, 1, 1}));
  bench.world.bodies.back().fixed = true;
  bench.initial.bodies.emplace_back();
  Simulation sim = bench.simulation("auto", kPresenceStep);
  EXPECT_EQ(refusalOfPresence(sim, 0, sim.body(0)), "body 'a' is present already");
  EXPECT_EQ(refusalOfPresence(sim, 3, std::nullopt), "body 'post' is fixed: it is always present");
  EXPECT_EQ(refusalOfPresence(sim, 9, std::nullopt), "no body has the index 9");
  sim.setPresent(0, std::nullopt);
  EXPECT_EQ(refusalOfPresence(sim, 0, std::nullopt), "body 'a' is absent already");
  BodyState state = bench.initial.bodies[0];
  state.x_W.x() = NAN;
  EXPECT_EQ(refusalOfPresence(sim, 0, state), "body 'a': position must be finite");
}

TEST(Presence, GoesOnFromAStateThatLacksABodyOnWhichTheWorldSchedulesAWrench) {
  Bench bench = threeOfWhichTwoAreLinked();
  PointWrench push;
  push.body = 2;
  push.force = {1, 0, 0};
  push.end = 10;
  bench.world.wrenches.push_back(push);
  Simulation sim = advanced(bench.simulation("auto", kPresenceStep), 5);
  sim.setPresent(2, std::nullopt);
  const Simulation taken_up(sim.world(), sim.state());
  test::expectSameState(advanced(taken_up, 20).state(), advanced(sim, 20).state());
}

// else it would be found when the body comes in
TEST(Presence, LawsThatABodyMayNotHaveAreRefusedWhileItIsAbsent) {
  Bench bench;
  bench.add(test::bodyOnPivot("top", {0.1, 0, 0.3}), test::tumbling({0, 0, 0}, {0.5, 1, 20}));
  bench.world.bodies[0].absent = true;
  EXPECT_NO_THROW(bench.simulation("auto", kPresenceStep));
  bench.world.laws.push_back(std::make_shared<CentralGravity>(0, Vector3d(9, 0, 0), 1.0, false));
  EXPECT_THROW(bench.simulation("auto", kPresenceStep), std::invalid_argument);
}

TEST(Presence, OfTheOnlyBodyMayEndAndBeginAgain) {
  Bench bench;
  bench.add(test::principalBody("a", 2, {1, 2, 2.5}), test::tumbling({0, 0, 1}, {0.5, 1, 0.2}));
  Simulation sim = bench.simulation("auto", kPresenceStep);
  sim.setPresent(0, std::nullopt);
  sim = advanced(sim, 10);
  EXPECT_EQ(totalsOf(sim.world(), sim.state()).energy, 0);
  sim.setPresent(0, bench.initial.bodies[0]);
  sim = advanced(sim, 10);
  EXPECT_NEAR(sim.body(0).x_W.z(), 0.1, 1e-15);
}

}  // namespace rigid_body_sim
