#include <map>

#include <gtest/gtest.h>
#include <interactive_markers/interactive_marker_client.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <tf2_ros/transform_listener.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "node_driver.hpp"
#include "ros/inputs/wrench_interfaces.hpp"
#include "ros/mouse/handle_topics.hpp"
#include "ros/mouse/handles.hpp"

namespace rigid_body_sim {
namespace {

/// The components of the node that have topics of their own for each body, in this process.
class BodySet : public ::testing::Test {
 protected:
  static geometry_msgs::WrenchStamped push() {
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = "world";
    message.wrench.force.x = 1;
    return message;
  }

  ros::NodeHandle nh;
  ros::NodeHandle private_nh{"~"};
  const Scene scene = parseScene(R"(
time_step: 0.01
bodies:
  - {name: a, shape: {sphere: {radius: 1}}, mass: 1, points: {tip: {position: [0, 0, 1]}}}
  - {name: b, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}
)",
                                 "test");
  const World world = buildWorld(scene);
  Simulation simulation{world, initialState(scene, world)};
  TimeOrigin origin;
  Refusals refusals;
  Inputs inputs{{[] { return false; }, {}, {}}, "world", simulation, origin, 0};
  Lockstep lockstep{NodeOptions(), world.solver.time_step};
  InputContext context{simulation, inputs, origin, refusals, lockstep};
};

}  // namespace

TEST_F(BodySet, BodyThatIsRemovedTakesNoWrenchUntilItIsAddedAgain) {
  NodeOptions options;
  options.wrench_timeout = 0;
  WrenchInterfaces wrenches(nh, private_nh, scene, context, options);
  ros::Publisher a = nh.advertise<geometry_msgs::WrenchStamped>("a/wrench", 10);
  ros::Publisher b = nh.advertise<geometry_msgs::WrenchStamped>("b/wrench", 10);
  ros::Publisher post = nh.advertise<geometry_msgs::WrenchStamped>("post/wrench", 10);
  ASSERT_TRUE(
      NodeDriver::waitFor([&] { return a.getNumSubscribers() + b.getNumSubscribers() == 2; }));
  EXPECT_EQ(post.getNumSubscribers(), 0U);

  wrenches.remove("a");
  ASSERT_TRUE(NodeDriver::waitFor([&] { return a.getNumSubscribers() == 0; }));
  b.publish(push());
  ASSERT_TRUE(NodeDriver::waitFor([&] { return simulation.wrenchCount(1) == 1; }));
  ApplyWrench call;
  call.request.wrench.header.frame_id = "b";
  call.request.wrench.body = "b";
  call.request.wrench.id = "x";
  call.request.wrench.point_frame = "a/tip";
  const auto apply = [&] {
    ros::AsyncSpinner serves(1);
    serves.start();
    EXPECT_TRUE(ros::service::call(private_nh.resolveName("apply_wrench"), call));
    serves.stop();
    return call.response.message;
  };
  EXPECT_NE(apply().find("unknown point_frame 'a/tip'"), std::string::npos);

  wrenches.add(scene.bodies[0], 0);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return a.getNumSubscribers() == 1; }));
  a.publish(push());
  ASSERT_TRUE(NodeDriver::waitFor([&] { return simulation.wrenchCount(0) == 1; }));
  EXPECT_EQ(apply(), "");
}

TEST_F(BodySet, HandleThatIsRemovedIsTakenBackFromTheViewersUntilItIsAddedAgain) {
  HandleTopics handles(private_nh, toHandles(scene, world), [](const HandleTopics::Feedback&) {});
  tf2_ros::Buffer buffer;
  geometry_msgs::TransformStamped b_in_a;
  b_in_a.header.frame_id = "a";
  b_in_a.child_frame_id = "b";
  b_in_a.transform.rotation.w = 1;
  buffer.setTransform(b_in_a, "test", true);
  interactive_markers::InteractiveMarkerClient viewer(buffer, "a", private_nh.resolveName("push"));
  std::map<std::string, int> shown;
  int resets = 0;
  viewer.setInitCb(
      [&](const boost::shared_ptr<const visualization_msgs::InteractiveMarkerInit>& all) {
        for (const auto& handle : all->markers) ++shown[handle.name];
      });
  viewer.setUpdateCb(
      [&](const boost::shared_ptr<const visualization_msgs::InteractiveMarkerUpdate>& update) {
        for (const auto& handle : update->markers) ++shown[handle.name];
        for (const std::string& name : update->erases) shown.erase(name);
      });
  viewer.setResetCb([&](const std::string&) { ++resets; });
  const auto waitFor = [&](const std::function<bool()>& condition) {
    return NodeDriver::waitFor([&] {
      handles.keepAlive(HandleTopics::Clock::now());
      viewer.update();
      return condition();
    });
  };
  ASSERT_TRUE(waitFor([&] { return shown.size() == 2; }));
  handles.remove("b");
  ASSERT_TRUE(waitFor([&] { return shown.count("b") == 0; }));
  handles.add(toHandle(scene.bodies[1], world.bodies[1]));
  ASSERT_TRUE(waitFor([&] { return shown.count("b") == 1; }));
  EXPECT_EQ(shown["a"], 1);
  EXPECT_EQ(resets, 0);  // no change was lost on the way
}

}  // namespace rigid_body_sim
