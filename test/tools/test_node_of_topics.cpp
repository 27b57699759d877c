#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ros/bag/node_of_topics.hpp"

namespace rigid_body_sim {
namespace {

/// Adds a topic as that of a body, box or ball, or as one of the node's own.
void add(const std::string& topic, NodeOfTopics& node) {
  for (const std::string name : {"box/wrench", "box/command", "ball/wrench"})
    if (topic.find("/" + name) != std::string::npos) return node.addTopicOfBody(topic, name);
  for (const std::string name : {"wrenches", "wrench"})
    if (topic.find("/" + name) != std::string::npos) return node.addOwnTopic(topic, name);
  node.addOwnTopic(topic, "wrench");  // remapped
}

bool areOfOneNode(const std::string& a, const std::string& b) {
  NodeOfTopics node;
  add(a, node);
  add(a, node);  // the same topic again
  try {
    add(b, node);
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(refused.what(), "must hold the inputs of one node, got " + a + " and " + b +
                                  "; rosbag filter separates them");
    return false;
  }
  return true;
}

}  // namespace

TEST(NodeOfTopics, HasOneNamespace) {
  const std::vector<std::string> topics = {"/sim/wrench", "/sim/wrenches", "/box/wrench",
                                           "/box/command", "/ball/wrench"};
  for (const std::string& a : topics)
    for (const std::string& b : topics) {
      EXPECT_TRUE(areOfOneNode(a, b)) << a << b;
      EXPECT_TRUE(areOfOneNode("/fleet/robot_a" + a, "/fleet/robot_a" + b)) << a << b;
      EXPECT_FALSE(areOfOneNode("/robot_a" + a, "/robot_b" + b)) << a << b;
      EXPECT_FALSE(areOfOneNode("/robot_a" + a, "/fleet/robot_a" + b)) << a << b;
      EXPECT_FALSE(areOfOneNode("/robot_a" + a, b)) << a << b;
    }
}

TEST(NodeOfTopics, HasOneName) {
  EXPECT_FALSE(areOfOneNode("/robot_a/sim/wrench", "/robot_a/other/wrenches"));
  EXPECT_FALSE(areOfOneNode("/sim/wrench", "/other/wrench"));
}

TEST(NodeOfTopics, MayHaveItsOwnTopicsRemapped) {
  for (const std::string remapped : {"/joystick", "/wrench", "/robot_b/joystick"}) {
    EXPECT_TRUE(areOfOneNode(remapped, "/robot_a/box/wrench"));
    EXPECT_TRUE(areOfOneNode("/robot_a/sim/wrenches", remapped));
    EXPECT_FALSE(areOfOneNode(remapped, "/robot_a/sim/wrench"));  // two of one type
  }
}

}  // namespace rigid_body_sim
