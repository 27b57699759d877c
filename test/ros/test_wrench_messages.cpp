#include <gtest/gtest.h>

#include "ros/inputs/wrench_messages.hpp"

namespace rigid_body_sim {
namespace {

const TimeOrigin kOrigin{ros::Time(1700000000, 500000000)};

AppliedWrench generalMessage() {
  AppliedWrench message;
  message.header.frame_id = "world";
  message.body = "box";
  message.id = "tug";
  message.point_frame = "box/tip";
  message.point.x = 1;
  message.wrench.force.y = 2;
  message.wrench.torque.z = 3;
  message.start = ros::Time(1700000002, 0);
  message.duration = ros::Duration(2, 4910000);
  return message;
}

}  // namespace

TEST(AppliedWrenchMessage, KeepsEveryField) {
  const WrenchRequest request = toRequest(generalMessage(), kOrigin);
  EXPECT_EQ(request.wrench.body, "box");
  EXPECT_EQ(request.wrench.frame, "world");
  EXPECT_EQ(request.wrench.point_frame, "box/tip");
  EXPECT_EQ(request.wrench.point, Vector3d(1, 0, 0));
  EXPECT_EQ(request.wrench.force, Vector3d(0, 2, 0));
  EXPECT_EQ(request.wrench.torque, Vector3d(0, 0, 3));
  EXPECT_EQ(request.wrench.start, 1.5);
  EXPECT_EQ(request.wrench.duration, 2.00491);
  EXPECT_FALSE(request.placed_by_frame);
}

TEST(AppliedWrenchMessage, HasOneSlotForEachId) {
  AppliedWrench message = generalMessage();
  const std::string tug = toRequest(message, kOrigin).slot;
  message.id = "other";
  EXPECT_NE(toRequest(message, kOrigin).slot, tug);
  message.id = "";
  EXPECT_EQ(toRequest(message, kOrigin).slot, "");
}

TEST(AppliedWrenchMessage, StartsAtTheNextStepWhenItSaysNothing) {
  AppliedWrench message = generalMessage();
  message.start = ros::Time();
  EXPECT_LT(toRequest(message, kOrigin).wrench.start, -1e300);
}

TEST(WrenchStamped, HasOneSlotForEachFrameApartFromThoseOfIds) {
  geometry_msgs::WrenchStamped message;
  message.header.frame_id = "tug";
  message.wrench.force.x = 4;
  const WrenchRequest request = toRequest("box", message);
  EXPECT_EQ(request.wrench.body, "box");
  EXPECT_EQ(request.wrench.frame, "tug");
  EXPECT_EQ(request.wrench.force, Vector3d(4, 0, 0));
  EXPECT_TRUE(request.placed_by_frame);
  EXPECT_NE(request.slot, toRequest(generalMessage(), kOrigin).slot);
  message.header.frame_id = "box";
  EXPECT_NE(toRequest("box", message).slot, request.slot);
}

}  // namespace rigid_body_sim
