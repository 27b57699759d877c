#include <random>

#include <gtest/gtest.h>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

/// A body with its centre of mass and its principal axes away from its frame.
Body lopsidedBody() {
  MassProperties properties;
  properties.mass = 2.5;
  properties.com_B = Vector3d(0.3, -0.2, 0.1);
  properties.I_Bcm << 1.0, 0.1, -0.2,  //
      0.1, 1.5, 0.05,                  //
      -0.2, 0.05, 2.0;
  return makeBody("lopsided", properties);
}

BodyFrameMotion someMotion() {
  BodyFrameMotion motion;
  motion.x_W = Vector3d(1, 2, 3);
  motion.q_WB = Quaterniond(0.5, -0.1, 0.7, 0.2).normalized();
  motion.v_W = Vector3d(-4, 0.5, 2);
  motion.w_W = Vector3d(3, -2, 5);
  return motion;
}

}  // namespace

TEST(Odometry, TwistIsThatOfTheBodyOriginInBodyAxes) {
  const Body body = lopsidedBody();
  const BodyFrameMotion motion = someMotion();
  const nav_msgs::Odometry odometry =
      toOdometry(body, toBodyState(body, motion), "world", ros::Time(7, 8));

  EXPECT_EQ(odometry.header.frame_id, "world");
  EXPECT_EQ(odometry.child_frame_id, "lopsided");
  EXPECT_EQ(odometry.header.stamp, ros::Time(7, 8));
  // a dozen products of numbers below 6: some 10 ulp of 6
  const double tolerance = 1e-14;
  const Vector3d v_B = motion.q_WB.conjugate() * motion.v_W;
  const Vector3d w_B = motion.q_WB.conjugate() * motion.w_W;
  EXPECT_LE((fromVector3(odometry.twist.twist.linear) - v_B).norm(), tolerance);
  EXPECT_LE((fromVector3(odometry.twist.twist.angular) - w_B).norm(), tolerance);
}

TEST(Odometry, PoseIsThatOfTheBodyFrame) {
  const Body body = lopsidedBody();
  const BodyFrameMotion motion = someMotion();
  const nav_msgs::Odometry odometry =
      toOdometry(body, toBodyState(body, motion), "world", ros::Time());
  const geometry_msgs::Quaternion& q = odometry.pose.pose.orientation;
  EXPECT_LE((fromPoint(odometry.pose.pose.position) - motion.x_W).norm(), 1e-14);
  EXPECT_LE(angleBetween(Quaterniond(q.w, q.x, q.y, q.z), motion.q_WB), 1e-14);
}

TEST(Odometry, CovarianceIsZero) {
  const Body body = lopsidedBody();
  const nav_msgs::Odometry odometry =
      toOdometry(body, toBodyState(body, someMotion()), "world", ros::Time());
  for (double c : odometry.pose.covariance) EXPECT_EQ(c, 0);
  for (double c : odometry.twist.covariance) EXPECT_EQ(c, 0);
}

TEST(Transform, IsThePoseOfTheOdometry) {
  const Body body = lopsidedBody();
  const BodyState state = toBodyState(body, someMotion());
  const nav_msgs::Odometry odometry = toOdometry(body, state, "map", ros::Time(1, 2));
  const geometry_msgs::TransformStamped transform =
      toTransform(body, state, "map", "lopsided", ros::Time(1, 2));
  EXPECT_EQ(transform.header, odometry.header);
  EXPECT_EQ(transform.child_frame_id, odometry.child_frame_id);
  EXPECT_EQ(transform.transform.translation.x, odometry.pose.pose.position.x);
  EXPECT_EQ(transform.transform.translation.y, odometry.pose.pose.position.y);
  EXPECT_EQ(transform.transform.translation.z, odometry.pose.pose.position.z);
  EXPECT_EQ(transform.transform.rotation, odometry.pose.pose.orientation);
}

TEST(TimeOrigin, StampsAreGoodToTheNanosecond) {
  const TimeOrigin origin{ros::Time(1700000000, 999999999)};
  EXPECT_EQ(origin.stamp(0), origin.start);
  EXPECT_EQ(origin.stamp(1e-9), ros::Time(1700000001, 0));
  EXPECT_EQ(origin.stamp(86400.000000001), ros::Time(1700086401, 0));
}

TEST(TimeOrigin, StampsComeBackAsSimulationTime) {
  std::mt19937 rng(42);
  std::uniform_int_distribution<std::int64_t> nanoseconds(0, 1000000000000);
  const TimeOrigin origin{ros::Time(1700000000, 123456789)};
  for (int i = 0; i < 1000; ++i) {
    const double t = static_cast<double>(nanoseconds(rng)) / 1e9;
    EXPECT_EQ(origin.simulationTime(origin.stamp(t)), t);
  }
  EXPECT_EQ(origin.simulationTime(ros::Time(1699999999, 123456789)), -1);
}

TEST(Duration, IsTheNearestDouble) {
  EXPECT_EQ(toSeconds(ros::Duration(2, 4910000)), 2.00491);
  EXPECT_EQ(toSeconds(ros::Duration(-1, 500000000)), -0.5);
}

TEST(TimeOrigin, SaysWhereRosTimeEnds) {
  const TimeOrigin zero;
  EXPECT_EQ(zero.stamp(4294967294.5), ros::Time(4294967294, 500000000));
  EXPECT_EQ((TimeOrigin{ros::Time(4294967000)}.stamp(200)), ros::Time(4294967200));
  for (const double t : {4294967296.0, 1e12, 1e300}) {
    EXPECT_FALSE(zero.hasStamp(t));
    EXPECT_THROW(zero.stamp(t), BeyondRosTime);
  }
  EXPECT_THROW((TimeOrigin{ros::Time(4294967000)}.stamp(400)), BeyondRosTime);
}

}  // namespace rigid_body_sim
