#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "node/message_bytes.hpp"
#include "support/published_run.hpp"

namespace rigid_body_sim {
namespace {

using Imus = std::vector<sensor_msgs::Imu>;

/// A lopsided box with two IMUs, and a fixed post with one.
Scene imuScene(double time_step, const std::string& rate = "200") {
  Scene scene = parseScene("time_step: 1\ngravity: [0.1, 0, -9.80665]\nbodies:\n" +
                               test::kLopsidedBox + R"(    position: [1, 2, 3]
    orientation: [0.5, 0.5, 0.5, 0.5]
    twist: {frame: world, linear: [1, -2, 3], angular: [0.5, -1, 2]}
    imus:
      noisy: {position: [0.1, -0.2, 0.3], orientation: {rpy: [0.1, 0.2, 0.3]}, rate: )" +
                               rate + R"(, seed: 5,
              gyroscope: {noise_density: 1e-4, bias: [1e-3, 0, 0], bias_walk: 1e-6},
              accelerometer: {noise_density: 2e-3, bias_walk: 3e-5}}
      plain: {rate: 30}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0], fixed: true,
     imus: {base: {rate: 10, accelerometer: {noise_density: 2e-3}}}}
)",
                           "test");
  scene.time_step = time_step;
  return scene;
}

Vector3d angularOf(const sensor_msgs::Imu& m) { return fromVector3(m.angular_velocity); }
Vector3d specificForceOf(const sensor_msgs::Imu& m) { return fromVector3(m.linear_acceleration); }

void expectSameBytes(const Imus& a, const Imus& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_EQ(bytesOf(a[k]), bytesOf(b[k])) << k;
}

}  // namespace

TEST(ImuOutput, StampsAreThoseOfItsSamplesWhateverStepAndPublishRate) {
  for (const double h : {0.003, 0.01, 0.32})
    for (const std::string rate : {"200", "333"}) {
      test::PublishedRun run(imuScene(h, rate), 7);
      run.steps(static_cast<int>(std::lround(1.92 / h)));
      const Imus& noisy = run.published.imu.at("box/noisy");
      ASSERT_EQ(noisy.size(), static_cast<std::size_t>(1.92 * std::stod(rate) + 1e-6) + 1);
      for (std::size_t k = 0; k < noisy.size(); ++k)
        ASSERT_EQ(noisy[k].header.stamp.toNSec() - run.origin.start.toNSec(),
                  static_cast<std::uint64_t>(
                      std::llround(1e9L * static_cast<long double>(k) / std::stold(rate))));
      EXPECT_EQ(run.published.imu.at("box/noisy/truth").size(), noisy.size());
      EXPECT_EQ(run.published.imu.at("box/plain").size(), 58U);
      EXPECT_EQ(run.published.odometry.at("box/odom").size(), 14U);
    }
}

TEST(ImuOutput, TruthIsTheMotionAtItsInstant) {
  test::PublishedRun run(imuScene(0.32), 100);
  run.outputs.publishDue();
  for (std::size_t k = 1; k < 64; ++k) {
    const double t = static_cast<double>(k) / 200;
    run.outputs.publishWithinStep(t);
    const sensor_msgs::Imu& truth = run.published.imu.at("box/noisy/truth").back();
    const Imu& imu = run.world.imus[0];
    const BodyMotion motion = run.simulation.motions({0}, t)[0];
    const ImuReading reading = readImu(imu, run.world.bodies[0], motion);
    EXPECT_EQ(angularOf(truth), reading.w_S);
    EXPECT_EQ(specificForceOf(truth), reading.f_S);
    const Quaterniond q_WB = toBodyFrameMotion(run.world.bodies[0], motion.state).q_WB;
    const geometry_msgs::Quaternion& q = truth.orientation;
    EXPECT_LT(angleBetween(Quaterniond(q.w, q.x, q.y, q.z), product(q_WB, imu.q_BS)), 1e-15);
  }
}

TEST(ImuOutput, CovariancesAreThoseOfWhiteNoise) {
  test::PublishedRun run(imuScene(0.01), 100);
  run.steps(1);
  const sensor_msgs::Imu& noisy = run.published.imu.at("box/noisy")[0];
  EXPECT_DOUBLE_EQ(noisy.angular_velocity_covariance[0], 1e-8 * 200);
  EXPECT_DOUBLE_EQ(noisy.linear_acceleration_covariance[4], 4e-6 * 200);
  EXPECT_EQ(noisy.linear_acceleration_covariance[1], 0);
  EXPECT_EQ(noisy.orientation_covariance[0], 0);
  const sensor_msgs::Imu& truth = run.published.imu.at("box/noisy/truth")[0];
  EXPECT_EQ(truth.angular_velocity_covariance[0], 0);
  EXPECT_EQ(truth.linear_acceleration_covariance[8], 0);
  EXPECT_EQ(noisy.header.frame_id, "box/noisy");
  EXPECT_EQ(truth.header.frame_id, "box/noisy");
}

TEST(ImuOutput, NoiseIsThatOfTheSampleNumber) {
  test::PublishedRun run(imuScene(0.01), 100);
  run.steps(50);
  ImuNoise noise(run.world.imus[0], "box");
  const Imus &noisy = run.published.imu.at("box/noisy"),
             &truth = run.published.imu.at("box/noisy/truth");
  for (std::size_t k = 0; k < noisy.size(); ++k) {
    const ImuReading expected = noise.addTo({angularOf(truth[k]), specificForceOf(truth[k])},
                                            static_cast<std::uint64_t>(k));
    ASSERT_EQ(angularOf(noisy[k]), expected.w_S);
    ASSERT_EQ(specificForceOf(noisy[k]), expected.f_S);
  }
}

TEST(ImuOutput, ReadsTheSameBitsWhoeverListensAndFromWhenOn) {
  test::PublishedRun always(imuScene(0.013), 100), late(imuScene(0.013), 100);
  late.published.subscribers = 0;
  for (test::PublishedRun* run : {&always, &late}) run->steps(70);
  EXPECT_TRUE(late.published.imu.empty());
  late.published.subscribers = 1;
  for (test::PublishedRun* run : {&always, &late}) run->steps(70);
  for (const auto& [name, messages] : late.published.imu) {
    const Imus& all = always.published.imu.at(name);
    ASSERT_GT(messages.size(), 5U);
    expectSameBytes(messages,
                    Imus(all.end() - static_cast<std::ptrdiff_t>(messages.size()), all.end()));
  }
}

TEST(ImuOutput, AsksForNoInstantWithoutSubscribers) {
  const test::PublishedRun run(imuScene(0.01), 100);
  test::PublishedMessages published;
  BodyTopics topics = openBodyTopics(published, run.world, 0);
  ImuOutput output(run.origin);
  output.add(run.world.imus[0], run.world.bodies[0], std::move(topics.imus[0]), "box/noisy", 0);
  EXPECT_EQ(output.next(), 0);
  published.subscribers = 0;
  EXPECT_EQ(output.next(), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(output.publishDue(run.simulation, 0, 0));
  published.subscribers = 1;
  EXPECT_EQ(output.next(), 1 / 200.0);
  output.remove(0);
  EXPECT_EQ(output.next(), std::numeric_limits<double>::infinity());
}

TEST(ImuOutput, LeavesOutSamplesThatWereDueBeforeAnybodyListened) {
  test::PublishedRun run(imuScene(0.32), 100);
  run.published.subscribers = 0;
  run.outputs.publishDue();
  run.simulation.step();
  run.published.subscribers = 1;
  run.outputs.publishDue();
  EXPECT_EQ(run.published.imu.at("box/noisy").size(), 1U);
  EXPECT_EQ(run.published.imu.at("box/noisy")[0].header.stamp,
            run.origin.start + ros::Duration(0, 320000000));
  EXPECT_EQ(run.published.imu.count("box/plain"), 0U);  // none at 0.32 s
}

TEST(ImuOutput, ReadsAWrenchFromItsStartOn) {
  Scene scene = parseScene(
      "time_step: 0.1\nbodies: [{name: ball, shape: {sphere: {radius: 1}}, mass: 2, imus: {imu: "
      "{rate: 40}}}]\nwrenches: [{body: ball, frame: world, force: [4, 0, 0], start: 0.025, "
      "duration: 0.025}]\n",
      "test");
  test::PublishedRun run(scene, 100);
  run.steps(1);
  const Imus& read = run.published.imu.at("ball/imu");
  ASSERT_EQ(read.size(), 5U);
  for (std::size_t k = 0; k < read.size(); ++k)
    EXPECT_EQ(read[k].linear_acceleration.x, k == 1 ? 2 : 0) << k;
}

TEST(ImuOutput, IncludesIMUsOfFixedBodies) {
  test::PublishedRun run(imuScene(0.01), 100);
  run.steps(100);
  EXPECT_EQ(run.published.imu.at("post/base").size(), 11U);
  EXPECT_EQ(specificForceOf(run.published.imu.at("post/base/truth")[3]),
            Vector3d(-0.1, 0, 9.80665));
  EXPECT_EQ(run.published.names.count("post/odom"), 0U);
  EXPECT_EQ(run.published.names.count("post/accel"), 0U);
}

TEST(ImuOutput, FramesAreStatic) {
  test::PublishedRun run(imuScene(0.01), 100);
  std::map<std::string, geometry_msgs::TransformStamped> frames;
  for (const auto& transform : run.published.tf[0].transforms)
    frames[transform.child_frame_id] = transform;
  ASSERT_EQ(frames.count("box/noisy"), 1U);
  EXPECT_EQ(frames["box/noisy"].header.frame_id, "box");
  EXPECT_EQ(frames["box/noisy"].transform.translation.y, -0.2);
  EXPECT_NEAR(frames["box/noisy"].transform.rotation.w, run.world.imus[0].q_BS.w(), 1e-15);
  EXPECT_EQ(frames["post/base"].header.frame_id, "post");
}

TEST(ImuOutput, NeverRepeatsASample) {
  test::PublishedRun run(imuScene(0.01), 100);
  run.steps(10);
  const std::size_t count = run.published.imu.at("box/noisy").size();
  run.outputs.setStanding(true);
  run.outputs.repeatState();
  run.outputs.publishNow();
  run.outputs.publishDue();
  EXPECT_EQ(run.published.imu.at("box/noisy").size(), count);
  EXPECT_EQ(run.published.come.count("box/noisy"), 0U);
}

TEST(ImuOutput, BeginsAnewWithTime) {
  test::PublishedRun run(imuScene(0.01), 100);
  run.steps(20);
  const Imus first = run.published.imu.at("box/noisy");
  run.published.imu.clear();
  run.simulation.reset(true);
  run.outputs.restart(0);
  run.steps(20);
  expectSameBytes(first, run.published.imu.at("box/noisy"));
}

TEST(Outputs, AccelerationIsTheDerivativeOfTheVelocityInOdometry) {
  constexpr double kStep = 0.001;
  test::PublishedRun run(imuScene(kStep), 1 / kStep);
  run.steps(60);
  const auto& odometry = run.published.odometry.at("box/odom");
  const auto& published = run.published.accelerations.at("box/accel");
  ASSERT_EQ(published.size(), odometry.size());
  std::vector<Vector3d> v, w;  // world axes
  for (const nav_msgs::Odometry& m : odometry) {
    v.push_back(rotate(test::attitude(m), fromVector3(m.twist.twist.linear)));
    w.push_back(rotate(test::attitude(m), fromVector3(m.twist.twist.angular)));
  }
  const auto derivative = [&](const std::vector<Vector3d>& x, std::size_t i) {
    return Vector3d((8 * (x[i + 1] - x[i - 1]) - (x[i + 2] - x[i - 2])) / (12 * kStep));
  };
  for (std::size_t i = 2; i + 2 < v.size(); ++i) {
    const Quaterniond q_WB = test::attitude(odometry[i]);
    EXPECT_EQ(published[i].header.stamp, odometry[i].header.stamp);
    EXPECT_EQ(published[i].header.frame_id, "box");
    ASSERT_LT((rotate(q_WB, fromVector3(published[i].accel.linear)) - derivative(v, i)).norm(),
              1e-9);
    ASSERT_LT((rotate(q_WB, fromVector3(published[i].accel.angular)) - derivative(w, i)).norm(),
              1e-9);
  }
}

}  // namespace rigid_body_sim
