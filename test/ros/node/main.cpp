#include <gtest/gtest.h>
#include <ros/ros.h>

/// Every rostest's program: the files *.test beside it say which of its suites they run.
int main(int argc, char** argv) {
  ros::init(argc, argv, "node_tests");
  ::testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
