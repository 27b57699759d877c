#include <cmath>

#include <gtest/gtest.h>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/arrow_markers.hpp"
#include "ros/outputs/rotor_markers.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

/// A ball of 2 kg and 0.5 m radius, its centre off the origin, with an actuator of each kind.
class ActuatorOutput : public ::testing::Test {
 protected:
  ActuatorOutput() {
    readings[0].force = 2 * 9.80665;  // as long as the body
    readings[1].speed = 10;
    readings[1].force = 9.80665 / 2;
    readings[1].torque = 0.25;
    readings[2].speed = -5;
    readings[2].torque = -9.80665;
  }

  static Body ball() {
    Thruster main;
    main.position_B = Vector3d(0.5, 0, 0);
    Rotor left;
    left.direction_B = Vector3d::UnitX();
    left.turns = -1;
    left.thrust = 8.5e-6;
    Wheel yaw;
    yaw.axis_B = Vector3d::UnitX();
    yaw.inertia = 0.01;
    return makeBody("ball", {2, Vector3d(0, 0, 0.1), Matrix3d::Identity() * 0.2},
                    {{"main", main}, {"left", left}, {"yaw", yaw}});
  }

  const Body body = ball();
  std::vector<ActuatorReading> readings{3};
};

Vector3d tailOf(const Marker& arrow) { return fromPoint(arrow.points.at(0)); }
Vector3d spanOf(const Marker& arrow) { return fromPoint(arrow.points.at(1)) - tailOf(arrow); }

/// [rad] How far the blade has turned about the direction of the rotor.
double turnOf(const Marker& blade) {
  const geometry_msgs::Quaternion& q = blade.pose.orientation;
  const Quaterniond at_rest(std::sqrt(0.5), 0, std::sqrt(0.5), 0);  // from z to x
  const Eigen::AngleAxisd turn(at_rest.conjugate() * Quaterniond(q.w, q.x, q.y, q.z));
  return turn.angle() * turn.axis().z();
}

}  // namespace

TEST_F(ActuatorOutput, IsSpeedAndForceOfARotorForceOfAThrusterSpeedAndTorqueOfAWheel) {
  const sensor_msgs::JointState message = toJointState(body, readings, ros::Time(5));
  EXPECT_EQ(message.header.stamp, ros::Time(5));
  EXPECT_EQ(message.name, (std::vector<std::string>{"main", "left", "yaw"}));
  EXPECT_TRUE(message.position.empty());
  EXPECT_EQ(message.velocity, (std::vector<double>{0, 10, -5}));
  EXPECT_EQ(message.effort, (std::vector<double>{2 * 9.80665, 9.80665 / 2, -9.80665}));
}

TEST_F(ActuatorOutput, IsDrawnAsArrowsOfForceAtItsPlaceAndOfTorqueOnTheBody) {
  const std::vector<Marker> arrows = actuatorArrows(body, "frame", readings);
  ASSERT_EQ(arrows.size(), 3U);
  for (const Marker& arrow : arrows) {
    EXPECT_EQ(arrow.header.frame_id, "frame");
    EXPECT_TRUE(arrow.frame_locked);
  }
  EXPECT_EQ(arrows[0].ns, "actuator/force");
  EXPECT_EQ(tailOf(arrows[0]), Vector3d(0.5, 0, 0));
  EXPECT_LT((spanOf(arrows[0]) - sizeOf(body) * Vector3d(0, 0, 1)).norm(), 1e-14);
  // a quarter of the weight, along x
  EXPECT_LT((spanOf(arrows[1]) - sizeOf(body) * Vector3d(0.5, 0, 0)).norm(), 1e-14);
  EXPECT_EQ(arrows[2].ns, "actuator/torque");
  EXPECT_EQ(tailOf(arrows[2]), Vector3d(0, 0, 0.1));
  EXPECT_GT(spanOf(arrows[2]).x(), 0);  // against the torque on the wheel
}

TEST_F(ActuatorOutput, ShowsRotorsThatTurnInTheirSense) {
  RotorMarkers rotors("frame", body);
  const double start = turnOf(rotors.at(1, readings).at(0));
  const std::vector<Marker> markers = rotors.at(1.05, readings);
  ASSERT_EQ(markers.size(), 2U);
  EXPECT_EQ(markers[0].ns, "rotor/blade");
  EXPECT_EQ(markers[0].header.frame_id, "frame");
  EXPECT_TRUE(markers[0].frame_locked);
  EXPECT_EQ(markers[1].ns, "rotor/disc");
  EXPECT_NEAR(std::remainder(turnOf(markers[0]) - start, 2 * std::acos(-1)), -0.5, 1e-12);
  readings[1].speed = 30;  // 20 rad/s in the mean
  EXPECT_NEAR(std::remainder(turnOf(rotors.at(1.1, readings).at(0)) - start, 2 * std::acos(-1)),
              -1.5, 1e-12);
}

TEST_F(ActuatorOutput, ShowsRotorsAcrossTheirDirection) {
  for (const Vector3d& direction :
       {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(0.48, -0.6, 0.64), Vector3d(0, 0.6, -0.8),
        Vector3d(1e-5, 0, -1).normalized()}) {
    Body turned = body;
    std::get<Rotor>(turned.actuators[1].kind).direction_B = direction;
    const Marker disc = RotorMarkers("frame", turned).at(0, readings).at(1);
    const geometry_msgs::Quaternion& q = disc.pose.orientation;
    const Vector3d across = rotate(Quaterniond(q.w, q.x, q.y, q.z), Vector3d(0, 0, 1));
    EXPECT_LT((across - direction).norm(), 1e-14);
  }
}

TEST_F(ActuatorOutput, ShowsRotorsAsLargeAsAPropellerOfTheirThrust) {
  Rotor nine_inches;
  nine_inches.thrust = 8.5e-6;
  EXPECT_NEAR(rotorDiameter(nine_inches, body), 0.23, 0.01);
  nine_inches.thrust = 0;
  EXPECT_DOUBLE_EQ(rotorDiameter(nine_inches, body), 0.1 * sizeOf(body));
  nine_inches.thrust = 1;
  EXPECT_DOUBLE_EQ(rotorDiameter(nine_inches, body), sizeOf(body));
}

}  // namespace rigid_body_sim
