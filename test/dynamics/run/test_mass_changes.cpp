#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>

#include "support/breaking_spring.hpp"
#include "support/changed_mass.hpp"
#include "support/contact_benches.hpp"
#include "support/law_benches.hpp"
#include "support/motor_benches.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Bodies whose mass properties are set while the run goes on.
namespace rigid_body_sim {
namespace {

using test::Bench;

constexpr double kChangeStep = 0.01;

/// Two bodies that fly, the first with its centre of mass and axes away from its frame.
Bench twoFlyers() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  Matrix3d I;
  I << 1, 0.1, -0.2, 0.1, 1.5, 0.05, -0.2, 0.05, 2;
  bench.add(makeBody("ship", {2, {0.3, -0.2, 0.1}, I}), test::tumbling({1, 2, 3}, {0.5, -1, 2}));
  bench.add(test::principalBody("other", 3, {1, 2, 2.5}), test::tumbling({5, 0, 0}, {1, 0.1, 0.2}));
  return bench;
}

Simulation stepped(Simulation sim, int steps) {
  for (int i = 0; i < steps; ++i) sim.step();
  return sim;
}

std::string refusalOfMass(Simulation& sim, std::size_t body, const MassProperties& properties) {
  return test::refusalThatChangesNothing(sim, [&] { sim.setMassProperties(body, properties); });
}

}  // namespace

TEST(MassChange, KeepsMomentaToTheLastBitWhereTheCentreStays) {
  Simulation sim = stepped(twoFlyers().simulation("auto", kChangeStep), 37);
  const BodyState before = sim.body(0);
  MassProperties fewer = test::propertiesOf(sim.world().bodies[0]);
  fewer.mass = 0.7;
  fewer.I_Bcm *= 0.3;
  sim.setMassProperties(0, fewer);
  const Body& body = sim.world().bodies[0];
  const BodyState after = sim.body(0);
  EXPECT_EQ(after.p_W, before.p_W);
  EXPECT_EQ(after.L_W, before.L_W);
  EXPECT_EQ(after.x_W, before.x_W);
  const BodyFrameMotion motion = toBodyFrameMotion(body, after);
  const Vector3d L_B = fewer.I_Bcm * rotateBack(motion.q_WB, motion.w_W);
  EXPECT_LT((rotate(motion.q_WB, L_B) - before.L_W).norm(), 1e-14 * before.L_W.norm());
  EXPECT_EQ(body.mass, 0.7);
}

TEST(MassChange, KeepsTheMomentumAboutTheOriginAndThePlaceWhereTheCentreMoves) {
  Simulation sim = stepped(twoFlyers().simulation("auto", kChangeStep), 37);
  const Totals before = totalsOf(sim.world(), sim.state());
  const BodyFrameMotion was = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  const MassProperties more = test::loaded(sim.world().bodies[0], 5, {1, 0.5, -2}, 0.1);
  sim.setMassProperties(0, more);
  const Totals after = totalsOf(sim.world(), sim.state());
  EXPECT_EQ(after.momentum, before.momentum);
  EXPECT_LT((after.angular_momentum - before.angular_momentum).norm(),
            1e-14 * before.angular_momentum.norm());
  const BodyFrameMotion is = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  EXPECT_LT((is.x_W - was.x_W).norm(), 1e-14);
  EXPECT_LT(is.q_WB.angularDistance(was.q_WB), 1e-14);
  // and both of its own
  const BodyState state = sim.body(0);
  EXPECT_LT((rotate(state.q_WP, state.L_P) - state.L_W).norm(), 1e-14 * state.L_W.norm());
}

TEST(MassChange, TakesAForceThatNamesNoPointAlongToTheNewCentre) {
  for (const bool pivoted : {false, true}) {
    Bench bench;
    const MassProperties box{2, {0.3, -0.2, 0.1}, Vector3d(1, 1.5, 2).asDiagonal()};
    std::optional<Vector3d> pivot_B;
    if (pivoted) pivot_B = Vector3d(0, 0, 1);
    bench.add(makeBody("box", box, {}, pivot_B), BodyFrameMotion());
    const Vector3d f_W(0, 3, 1);
    // of the world, by an input, and to come
    bench.world.wrenches.push_back(wrenchAtCenterOfMass(bench.world.bodies, 0, f_W, {0, 0, 0}));
    Simulation sim = bench.simulation("auto", kChangeStep);
    PointWrench push = wrenchAtCenterOfMass(sim.world().bodies, 0, f_W, Vector3d::Zero());
    sim.applyWrench("now", push);
    push.start = 0.5;
    sim.applyWrench("to come", push);
    sim.setMassProperties(0, {4, {-0.1, 0.4, 0.2}, Vector3d(2, 3, 4).asDiagonal()});
    const Body& body = sim.world().bodies[0];
    for (const PointWrench& acting : sim.activeWrenches(0)) EXPECT_EQ(acting.point, body.com_P);
    EXPECT_EQ(sim.activeWrenches(0).size(), 2U);
    if (pivoted) continue;  // there the force turns it, about the pivot
    sim = stepped(sim, 100);
    EXPECT_EQ(sim.body(0).L_P, Vector3d::Zero());
    EXPECT_LT((sim.body(0).p_W - 2.5 * f_W).norm(), 1e-14 * 2.5 * f_W.norm());
  }
}

TEST(MassChange, LeavesAForceWhereItsPointIsNamedThoughItIsTheCentre) {
  Bench bench;
  bench.add(test::principalBody("box", 1, {1, 1.5, 2}), BodyFrameMotion());
  Simulation sim = bench.simulation("auto", kChangeStep);
  sim.applyWrench("", wrenchInWorldAxes(sim.world().bodies, 0, {0, 0, 1}, {0, 0, 0}, {0, 0, 0}));
  sim.setMassProperties(0, {1, {0.5, 0, 0}, Vector3d(1, 1.5, 2).asDiagonal()});
  EXPECT_EQ(sim.activeWrenches(0)[0].point, Vector3d(-0.5, 0, 0));
}

TEST(MassChange, RefusesAForceAtTheCentreThatNamesAnotherPoint) {
  Simulation sim = twoFlyers().simulation("auto", kChangeStep);
  PointWrench push = wrenchAtCenterOfMass(sim.world().bodies, 0, {1, 0, 0}, {0, 0, 0});
  push.point.x() = 1e-9;
  try {
    sim.applyWrench("", push);
    FAIL() << "was taken";
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(),
                 "wrench on body 'ship': at its centre of mass, point must be that of the body");
  }
}

TEST(MassChange, IsRefusedWhereVelocitiesWouldNotBeFinite) {
  Simulation sim = stepped(twoFlyers().simulation("auto", kChangeStep), 3);
  const MassProperties known = test::propertiesOf(sim.world().bodies[0]);
  for (const MassProperties& dust : {MassProperties{1e-308, known.com_B, known.I_Bcm},
                                     MassProperties{2, known.com_B, 1e-308 * known.I_Bcm}})
    EXPECT_EQ(refusalOfMass(sim, 0, dust),
              "body 'ship': with the momenta that it keeps, velocities and energy would not be "
              "finite; another mass or inertia is needed");
}

TEST(MassChange, LeavesOtherBodiesTheirBits) {
  Simulation left = stepped(twoFlyers().simulation("auto", kChangeStep), 20), changed = left;
  changed.setMassProperties(0, test::loaded(left.world().bodies[0], 5, {1, 0.5, -2}, 0.1));
  left = stepped(left, 30);
  changed = stepped(changed, 30);
  test::expectSameBodyState(changed.body(1), left.body(1));
  EXPECT_NE(changed.body(0).x_W, left.body(0).x_W);
}

TEST(MassChange, EndsWithAReset) {
  Simulation sim = twoFlyers().simulation("auto", kChangeStep);
  const State start = sim.state();
  sim = stepped(sim, 5);
  sim.setMassProperties(0, test::loaded(sim.world().bodies[0], 5, {1, 0.5, -2}, 0.1));
  sim = stepped(sim, 5);
  sim.reset(true);
  test::expectSameState(sim.state(), start);
  EXPECT_EQ(sim.world().bodies[0].mass, 2);
}

TEST(MassChange, IsBookedAsWork) {
  for (Bench bench : {twoFlyers(), test::boxOnSpring(0.3)}) {
    Simulation sim = bench.simulation("auto", kChangeStep);
    sim.trackBalance();
    sim = stepped(sim, 20);
    const double before = mechanicalEnergy(sim.world(), sim.state());
    const double work = sim.exchanged().energy;
    sim.setMassProperties(0, test::loaded(sim.world().bodies[0], 1, {0.1, 0.05, -0.2}, 0.1));
    const double gained = mechanicalEnergy(sim.world(), sim.state()) - before;
    EXPECT_GT(std::abs(gained), 0.1);
    EXPECT_NEAR(sim.exchanged().energy - work, gained, 1e-12);
    sim = stepped(sim, 20);
    EXPECT_LT(std::abs(sim.balance().energy), 1e-8);
    EXPECT_LT(sim.balance().momentum.norm(), 1e-8);
    EXPECT_LT(sim.balance().angular_momentum.norm(), 1e-8);
  }
}

TEST(MassChange, OfABodyOnAPivotKeepsItsMomentumAboutThePivot) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(test::bodyOnPivot("top", {0.1, 0, 0.3}), test::tumbling({0, 0, 0}, {0.5, 1, 20}));
  Simulation sim = bench.simulation("auto", kChangeStep);
  sim.trackBalance();
  sim = stepped(sim, 20);
  const BodyState before = sim.body(0);
  Matrix3d I;
  I << 0.6, 0.02, -0.03, 0.02, 0.7, 0.05, -0.03, 0.05, 0.9;
  sim.setMassProperties(0, {3, {0.1, 0.1, -0.4}, I});
  EXPECT_EQ(sim.body(0).L_W, before.L_W);
  EXPECT_EQ(sim.body(0).x_W, before.x_W);
  EXPECT_EQ(Vector3d(sim.world().bodies[0].X_BP.translation()), Vector3d(0.1, 0, 0.3));
  sim = stepped(sim, 20);
  EXPECT_LT(std::abs(sim.balance().energy), 1e-9);
  EXPECT_LT(sim.balance().momentum.norm(), 1e-9);
  EXPECT_LT(sim.balance().angular_momentum.norm(), 1e-9);
}

TEST(MassChange, KeepsSpeedsOfRotorsAndMomentaOfWheels) {
  Simulation sim = stepped(
      test::benchOf(test::motley(), test::motleyStart()).simulation("auto", kChangeStep), 20);
  const State before = sim.state();
  sim.setMassProperties(0, test::loaded(sim.world().bodies[0], 1, {0, 0, 0.3}, 0.1));
  const State after = sim.state();
  ASSERT_FALSE(after.actuators[0].empty());
  for (std::size_t k = 0; k < after.actuators[0].size(); ++k)
    test::expectSameActuator(after.actuators[0][k], before.actuators[0][k]);
  EXPECT_EQ(after.bodies[0].p_W, before.bodies[0].p_W);
}

TEST(MassChange, WakesABodyThatRests) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.world.solver.tolerance = 1e-4;
  test::addBox(bench, {0.2, 0.3, 0.1}, 1, test::motionAt({0, 0, 0.05}), HalfSpace{},
               test::contactOf(1e4, 1.5, 0.5, 0.5));
  Simulation sim = bench.simulation("auto", kChangeStep);
  while (sim.time() < 20 && !sim.plans()[0].at_rest) sim.step();
  ASSERT_TRUE(sim.plans()[0].at_rest);
  // its centre is beyond its edge from now on
  sim.setMassProperties(0, test::loaded(sim.world().bodies[0], 20, {0.3, 0, 0}, 0.1));
  EXPECT_FALSE(sim.plans()[0].at_rest);
  sim = stepped(sim, 10);
  EXPECT_GT(angleBetween(toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB,
                         Quaterniond::Identity()),
            0.01);
}

TEST(MassChange, IsRefusedInOneLineAndLeavesAllAsItWas) {
  Simulation sim = stepped(twoFlyers().simulation("auto", kChangeStep), 3);
  MassProperties given = test::propertiesOf(sim.world().bodies[0]);
  given.mass = -1;
  EXPECT_EQ(refusalOfMass(sim, 0, given), "body 'ship': mass must be > 0 kg, got -1");
  given.mass = 1;
  given.I_Bcm = Vector3d(1, 1, 5).asDiagonal();
  EXPECT_NE(refusalOfMass(sim, 0, given).find("body 'ship': "), std::string::npos);
  EXPECT_EQ(refusalOfMass(sim, 7, given), "no body has the index 7");
  // less inertia than the wheels have
  Simulation motors = test::benchOf(test::motley(), test::motleyStart()).simulation("auto", 0.01);
  given.I_Bcm = Matrix3d::Identity() * 1e-9;
  EXPECT_NE(refusalOfMass(motors, 0, given), "");
}

TEST(MassChange, IsRefusedByALawThatDoesNotFollow) {
  Bench bench = twoFlyers();
  bench.world.laws.push_back(std::make_shared<test::BreakingSpring>(
      Spring::End{0, {0, 0, 0}}, Spring::End{kWorld, {0, 0, 9}}, 10, 1e9));
  Simulation sim = bench.simulation("auto", kChangeStep);
  EXPECT_NE(refusalOfMass(sim, 0, test::loaded(sim.world().bodies[0], 1, {0, 0, 0}, 0.1))
                .find("does not follow a change of mass properties"),
            std::string::npos);
  EXPECT_EQ(refusalOfMass(sim, 1, test::loaded(sim.world().bodies[1], 1, {0, 0, 0}, 0.1)), "");
}

TEST(MassChange, IsRefusedWhereEnergyWouldNotBeFinite) {
  Simulation sim = stepped(twoFlyers().simulation("auto", kChangeStep), 3);
  MassProperties given = test::propertiesOf(sim.world().bodies[0]);
  given.mass = 1e308;
  EXPECT_NE(refusalOfMass(sim, 0, given).find("would not be finite"), std::string::npos);
  BodyState fast = sim.body(0);
  fast.p_W = {0, 0, 1e200};
  EXPECT_THROW(sim.setState(0, fast), std::invalid_argument);
  EXPECT_NE(sim.body(0).p_W, fast.p_W);
}

TEST(MassChange, KeepsTheSignOfTheAttitude) {
  Simulation sim = twoFlyers().simulation("auto", kChangeStep);
  for (int i = 0; i < 20; ++i) {
    const Quaterniond before = toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB;
    MassProperties turned = test::propertiesOf(sim.world().bodies[0]);
    const Matrix3d R(Eigen::AngleAxisd(0.7 * i, Vector3d(1, 2, 3).normalized()));
    turned.I_Bcm = R * turned.I_Bcm * R.transpose();
    sim.setMassProperties(0, turned);
    EXPECT_GT(before.dot(toBodyFrameMotion(sim.world().bodies[0], sim.body(0)).q_WB), 0) << i;
    sim.step();
  }
}

}  // namespace rigid_body_sim
