#include <cmath>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"
#include "support/worlds.hpp"

namespace rigid_body_sim {

using test::Bench;

namespace {

Imu imuAt(const Vector3d& position) {
  Imu imu;
  imu.name = "imu";
  imu.position_B = position;
  imu.rate = 200;
  return imu;
}

ImuReading readingOf(const Simulation& sim, const Imu& imu, std::size_t body = 0) {
  return readImu(imu, sim.world().bodies[body], sim.motions({body}, sim.time())[0]);
}

}  // namespace

TEST(Imu, ReadsExactlyZeroInFreeFall) {
  Bench bench;
  bench.world.g_W = {0.3, -0.1, -9.80665};
  // that does not turn: all of it falls alike; one that does: at its centre of mass
  bench.add(test::principalBody("falling", 2, {1, 2, 2.5}), test::motionAt({1, 2, 3}, {4, 5, 6}));
  bench.add(test::principalBody("tumbling", 2, {1, 2, 2.5}), test::tumbling({1, 0, 5}, {1, 2, 3}));
  for (const char* integrator : {"auto", "dop853", "rk4"}) {
    Simulation sim = bench.simulation(integrator, 0.01);
    for (int i = 0; i < 20; ++i, sim.step()) {
      EXPECT_EQ(readingOf(sim, imuAt({0.1, 0.2, -0.3}), 0).f_S, Vector3d::Zero());
      EXPECT_EQ(readingOf(sim, imuAt({0, 0, 0}), 1).f_S, Vector3d::Zero());
    }
  }
}

TEST(Imu, ReadsGravityUpwardsAtRestOnTheGround) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, test::motionAt({0, 0, 0.1}), test::slope(0),
               test::contactOf(1e5, 1.5, 2, 0.5));
  Simulation sim = bench.simulation("auto", 0.01);
  for (int i = 0; i < 300; ++i) sim.step();
  ASSERT_TRUE(sim.plans()[0].at_rest);
  Imu imu = imuAt({0.1, 0, 0.05});
  imu.q_BS = rotationExp(Vector3d(0, 0, 0.7));
  const ImuReading reading = readingOf(sim, imu);
  EXPECT_LT((reading.f_S - Vector3d(0, 0, 9.80665)).norm(), 1e-7);  // it leans by its rounding
  EXPECT_NEAR(reading.f_S.norm(), 9.80665, 4e-15);
  EXPECT_EQ(reading.w_S.norm(), 0);
}

TEST(Imu, ReadsMinusGravityOnAFixedBody) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  bench.add(test::principalBody("post", 2, {1, 2, 2.5}), BodyFrameMotion());
  bench.world.bodies[0].fixed = true;
  Simulation sim = bench.simulation("auto", 0.01);
  EXPECT_EQ(readingOf(sim, imuAt({1, 2, 3})).f_S, Vector3d(0, 0, 9.80665));

  bench.world.gravity_centers.push_back({Vector3d::Zero(), 8});  // where its centre of mass is
  const Vector3d f = readingOf(bench.simulation("auto", 0.01), imuAt({0, 0, 2})).f_S;
  EXPECT_LT((f - Vector3d(0, 0, 9.80665 + 2)).norm(), 1e-15);
}

TEST(Imu, ReadsTheCentripetalAccelerationOfItsPlace) {
  Bench bench;
  bench.add(test::principalBody("table", 2, {1, 2, 2.5}), test::tumbling({0, 0, 0}, {0, 0, 3}));
  const Simulation sim = bench.simulation("auto", 0.01);
  const ImuReading reading = readingOf(sim, imuAt({0.2, -0.1, 0.4}));
  EXPECT_LT((reading.f_S - Vector3d(-9 * 0.2, 9 * 0.1, 0)).norm(), 1e-15);
  EXPECT_LT((reading.w_S - Vector3d(0, 0, 3)).norm(), 1e-15);

  // in its own axes: x along the table's z
  Imu turned = imuAt({0.2, -0.1, 0.4});
  turned.q_BS = rotationExp(Vector3d(0, -M_PI / 2, 0));
  const ImuReading there = readingOf(sim, turned);
  EXPECT_LT((there.w_S - Vector3d(3, 0, 0)).norm(), 1e-14);
  EXPECT_LT((there.f_S - Vector3d(0, 9 * 0.1, 9 * 0.2)).norm(), 1e-14);
}

TEST(Imu, ReadsFromTheCentreOfMassAndInTheAxesOfItsBody) {
  Bench bench;
  Matrix3d I;
  I << 2, 0.3, 0, 0.3, 3, -0.2, 0, -0.2, 3.5;
  const Vector3d center(0.1, -0.3, 0.2), place(0.5, 0.4, -0.1), w_B(0.7, -1.1, 0.4);
  BodyFrameMotion motion = test::tumbling({0, 0, 0}, w_B, Quaterniond(0.5, 0.5, -0.5, 0.5));
  bench.add(makeBody("box", {2, center, I}), motion);
  const ImuReading reading = readingOf(bench.simulation("auto", 0.01), imuAt(place));
  const Vector3d w_dot_B = I.inverse() * (I * w_B).cross(w_B), arm = place - center;
  EXPECT_LT((reading.w_S - w_B).norm(), 1e-14);
  EXPECT_LT((reading.f_S - (w_dot_B.cross(arm) + w_B.cross(w_B.cross(arm)))).norm(), 1e-14);
}

TEST(Imu, ReadsTheTideUnderCentralGravity) {
  constexpr double kMu = 3.986004418e14;
  using Vector = Vector3<long double>;
  Bench bench;
  bench.world.g_W = {0, 0, -0.01};
  const Vector3d place(6.9e6, 1.2e6, -3e5), arm(1.5, -2, 0.7);
  bench.add(test::principalBody("satellite", 500, {100, 200, 250}), test::motionAt(place));
  bench.addCentralGravity(0, {100, 0, 0}, kMu, false);
  const Vector3d f = readingOf(bench.simulation("dop853", 0.01), imuAt(arm)).f_S;
  const auto gravityAt = [&](const Vector& x) {
    const Vector r = x - Vector(100, 0, 0);
    return Vector(-static_cast<long double>(kMu) / (r.norm() * r.squaredNorm()) * r);
  };
  const Vector center = place.cast<long double>();
  const Vector tide = gravityAt(center) - gravityAt(center + arm.cast<long double>());
  EXPECT_GT(tide.norm(), 1e-7);
  EXPECT_LT((f - tide.cast<double>()).norm(), 1e-11 * f.norm());

  // nothing else: at the centre of mass it is zero
  EXPECT_EQ(readingOf(bench.simulation("dop853", 0.01), imuAt({0, 0, 0})).f_S, Vector3d::Zero());
}

TEST(Imu, ReadsTheTorqueOfTheGravityGradientButNotItsForce) {
  Bench bench;
  bench.add(test::principalBody("rod", 1, {1, 2, 2.5}), test::motionAt({1, 1, 0}));
  bench.addCentralGravity(0, {0, 0, 0}, 4, true);
  const Simulation sim = bench.simulation("dop853", 0.01);
  const Vector3d n = Vector3d(1, 1, 0).normalized(), I(1, 2, 2.5);
  const double mu_r3 = 4 / std::pow(2, 1.5);
  const Vector3d w_dot = (3 * mu_r3 * n.cross(I.cwiseProduct(n))).cwiseQuotient(I);
  EXPECT_GT(w_dot.z(), 0.1);
  // so near to the centre of mass that the tide is linear
  for (const Vector3d& arm : {Vector3d(1e-6, 0, 0), Vector3d(0, 0, 1e-6)}) {
    const Vector3d tide = mu_r3 * (arm - 3 * n.dot(arm) * n);
    EXPECT_LT((readingOf(sim, imuAt(arm)).f_S - tide - w_dot.cross(arm)).norm(), 1e-11);
  }
}

TEST(Imu, OfAWorldIsChecked) {
  const auto faultOf = [](const Imu& imu) {
    Bench bench = test::restingBox();
    bench.world.imus = {imu};
    try {
      bench.simulation("auto", 0.01);
    } catch (const std::invalid_argument& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  EXPECT_EQ(faultOf(imuAt({0, 0, 0})), "");
  Imu imu = imuAt({0, 0, 0});
  imu.rate = 0;
  EXPECT_EQ(faultOf(imu), "body 'box': IMU 'imu': rate must be > 0 Hz, got 0");
  imu.rate = 1;
  imu.gyroscope.density = -1;
  EXPECT_EQ(faultOf(imu), "body 'box': IMU 'imu': gyroscope noise density must be >= 0, got -1");
  imu.body = 1;
  EXPECT_EQ(faultOf(imu), "no body has the index 1");
}

}  // namespace rigid_body_sim
