#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/contact.hpp>

#include "math/sanitizers.hpp"
#include "support/method_cases.hpp"

/// What the state of a body on a pivot holds, and what others read from it.
namespace rigid_body_sim {
namespace {

using test::Bench;

#if defined(RIGID_BODY_SIM_ADDRESS_SANITIZER)
constexpr int kManySteps = 20000;  // sanitizers look at the code, not at the drift
#else
constexpr int kManySteps = 1000000;
#endif

/// Where the pivot of body 0 is, from what users read: exactly.
Vector3<long double> pivotOf(const Simulation& sim) {
  const Body& body = sim.world().bodies[0];
  const BodyFrameMotion m = toBodyFrameMotion(body, sim.body(0));
  return m.x_W.cast<long double>() + m.q_WB.cast<long double>().normalized().toRotationMatrix() *
                                         body.X_BP.translation().cast<long double>();
}

Bench farPivot() {
  Bench bench = test::pushedOnPivot();
  BodyFrameMotion motion = test::tumbling({0, 0, 0}, {1, -0.7, 0.4});
  motion.x_W = {0.1, -7.3, 123.4};
  bench.world.wrenches[0].point += motion.x_W;
  bench.initial.bodies[0] = toBodyState(bench.world.bodies[0], motion);
  return bench;
}

}  // namespace

TEST(Pivot, StaysInPlaceForAMillionSteps) {
  for (const char* integrator : {"auto", "rk4", "strang", "dop853"}) {
    const bool is_dear = integrator == std::string("dop853");
    Simulation sim = farPivot().simulation(integrator, 1e-3);
    sim.step();
    const BodyState first = sim.body(0);
    const auto place = pivotOf(sim);
    for (int i = 0; i < (is_dear ? kManySteps / 10 : kManySteps); ++i) sim.step();
    const BodyState last = sim.body(0);
    EXPECT_EQ(last.x_W, first.x_W) << integrator;
    EXPECT_EQ(last.x_low_W, first.x_low_W) << integrator;
    EXPECT_EQ(last.p_W, Vector3d::Zero()) << integrator;
    EXPECT_LE((pivotOf(sim) - place).cwiseAbs().maxCoeff(), 0x1p-46L)
        << integrator;  // 1 ulp of 123
    EXPECT_GT(angleBetween(last.q_WP, first.q_WP), 1e-3) << integrator;
  }
}

TEST(Pivot, IsPutWhereAPoseSaysAndIgnoresTheLinearVelocity) {
  Simulation sim = farPivot().simulation("auto", 1e-2);
  sim.step();
  const Body& body = sim.world().bodies[0];
  BodyFrameMotion set;
  set.x_W = {1, 2, 3};
  set.q_WB = Quaterniond(0.5, 0.5, -0.5, 0.5);
  set.v_W = {10, 20, 30};
  set.w_W = {0.3, 0.2, -1};
  sim.apply(StateInput{0, set});
  const BodyFrameMotion read = toBodyFrameMotion(body, sim.body(0));
  EXPECT_LT((read.x_W - set.x_W).norm(), 1e-15);
  EXPECT_LT((read.w_W - set.w_W).norm(), 1e-15);
  const Vector3d arm_W = set.q_WB.toRotationMatrix() * body.X_BP.translation();
  EXPECT_LT((read.v_W + set.w_W.cross(arm_W)).norm(), 1e-14);
  const auto place = pivotOf(sim);
  for (int i = 0; i < 100; ++i) sim.step();
  EXPECT_LT((pivotOf(sim) - place).norm(), 1e-15L);
}

TEST(Pivot, RefusesAStateWithMomentum) {
  Bench bench = test::pushedOnPivot();
  bench.initial.bodies[0].p_W = {0, 0, 1};
  try {
    bench.simulation("auto", 1e-2);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(
        std::string(refused.what()),
        "body 'box': its momentum must be zero, for it is on a pivot and its state is its rotation "
        "alone");
  }
}

TEST(Pivot, RefusesLawsOnTheCentreOfMass) {
  const auto faultOf = [](const Bench& bench) -> std::string {
    try {
      bench.simulation("auto", 1e-2);
    } catch (const std::invalid_argument& refused) {
      return refused.what();
    }
    return "";
  };
  const std::string rule =
      "body 'box' is on a pivot, beside which contact and central gravity are not supported, and "
      "linear and quadratic drag as MediumDrag alone";
  for (const Drag::Coefficients& drag :
       {Drag::Coefficients{1, 0, 0}, Drag::Coefficients{0, 1, 0}}) {
    Bench dragged = test::pushedOnPivot();
    dragged.addDrag(0, drag);
    EXPECT_EQ(faultOf(dragged), "law 'drag': " + rule);
  }
  Bench braked = test::pushedOnPivot();
  braked.addDrag(0, {0, 0, 1});
  EXPECT_EQ(faultOf(braked), "");
  Bench attracted = test::pushedOnPivot();
  attracted.addCentralGravity(0, {9, 0, 0}, 1, false);
  EXPECT_EQ(faultOf(attracted), "law 'central gravity': " + rule);
  Bench touching = test::pushedOnPivot();
  ContactShape ball;
  ball.balls = {{Vector3d::Zero(), 1}};
  touching.world.laws.push_back(
      contactWithHalfSpace(touching.world.bodies, 0, ball, HalfSpace{}, ContactParameters{1e5}));
  EXPECT_EQ(faultOf(touching), "law 'contact': " + rule);
}

// Angular drag on the rotation about the pivot: L′ = −(k/I) L about an axis of symmetry.
TEST(Pivot, IsBrakedByAngularDrag) {
  for (const char* integrator : {"auto", "rk4", "strang"}) {
    Bench bench;
    bench.add(
        makeBody("table", {2, {0, 0, 0}, Vector3d(1, 1, 2).asDiagonal()}, {}, Vector3d(0.5, 0, 0)),
        test::tumbling({0, 0, 0}, {0, 0, 3}));
    bench.addDrag(0, {0, 0, 0.5});
    const State end = bench.run(integrator, 1, 100);
    EXPECT_NEAR(end.bodies[0].L_W.z(), 2.5 * 3 * std::exp(-0.5 / 2.5), 1e-8) << integrator;
    EXPECT_EQ(end.bodies[0].p_W, Vector3d::Zero());
  }
}

// By what the body is made of, seen from outside: half m v² of the centre of mass and half ω·J ω.
TEST(Totals, AreThoseOfTheCentreOfMassOfABodyOnAPivot) {
  const MassProperties mass{2, {0.3, 0, 0}, Vector3d(0.5, 0.7, 0.9).asDiagonal()};
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  BodyFrameMotion motion = test::tumbling({0, 0, 0}, {0, 0, 2});
  motion.x_W = {1, 0, 5};
  bench.add(makeBody("arm", mass, {}, Vector3d::Zero()), motion);
  const Totals has = totalsOf(bench.world, bench.initial);
  EXPECT_NEAR(has.energy, 0.5 * 2 * 0.36 + 0.5 * 0.9 * 4 + 2 * 10 * 5, 1e-13);
  EXPECT_LT((has.momentum - Vector3d(0, 2 * 0.6, 0)).norm(), 1e-15);
  const Vector3d L = Vector3d(1.3, 0, 5).cross(Vector3d(0, 1.2, 0)) + Vector3d(0, 0, 0.9 * 2);
  EXPECT_LT((has.angular_momentum - L).norm(), 1e-14);
}

TEST(Pivot, IsRefusedWhereItIsNotFinite) {
  const MassProperties mass{1, {0, 0, 0}, Matrix3d::Identity()};
  EXPECT_THROW(makeBody("far", mass, {}, Vector3d(1e200, 0, 0)), std::invalid_argument);
  EXPECT_THROW(makeBody("far", mass, {}, Vector3d(0, NAN, 0)), std::invalid_argument);
}

}  // namespace rigid_body_sim
