#include <map>

#include <gtest/gtest.h>
#include <interactive_markers/interactive_marker_client.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/MarkerArray.h>

#include <rigid_body_sim/ClearWrenches.h>

#include "node_beside_core.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerFeedback;
using visualization_msgs::InteractiveMarkerInit;
using visualization_msgs::InteractiveMarkerUpdate;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// A viewer's side of the handles, by the client that rviz uses.
class Viewer {
 public:
  Viewer() : listener_(buffer_), client_(buffer_, "world", "rigid_body_node/push") {
    client_.setInitCb([this](const boost::shared_ptr<const InteractiveMarkerInit>& all) {
      for (const InteractiveMarker& handle : all->markers) handles[handle.name] = handle;
    });
    client_.setUpdateCb([this](const boost::shared_ptr<const InteractiveMarkerUpdate>& update) {
      for (const auto& pose : update->poses) put_back.push_back(pose);
    });
    client_.setResetCb([this](const std::string&) { ++resets; });
    feedback_ = nh_.advertise<InteractiveMarkerFeedback>("rigid_body_node/push/feedback", 100);
  }

  bool isReady() {
    client_.update();
    return !handles.empty() && feedback_.getNumSubscribers() > 0;
  }

  /// Whether a handle has been put back: then the node knows of its release.
  bool isPutBack() {
    client_.update();
    return !put_back.empty();
  }

  /// Sends feedback on the canary's handle, pressed at the top of the ball, as rviz does: the mouse
  /// is at a place in the world, and the handle is dragged there in the frame of the body.
  void send(int event, const nav_msgs::Odometry& canary, const Vector3d& mouse_W) {
    const geometry_msgs::Quaternion& q = canary.pose.pose.orientation;
    const Vector3d mouse_B = Quaterniond(q.w, q.x, q.y, q.z).conjugate() *
                             (mouse_W - fromPoint(canary.pose.pose.position));
    InteractiveMarkerFeedback feedback;
    feedback.header.frame_id = feedback.marker_name = "canary";
    feedback.header.stamp = canary.header.stamp;
    feedback.client_id = name;
    feedback.event_type = static_cast<InteractiveMarkerFeedback::_event_type_type>(event);
    feedback.pose.position = toPoint(mouse_B - top);
    feedback.pose.orientation.w = 1;
    feedback.mouse_point = toPoint(top);
    feedback.mouse_point_valid = true;
    feedback_.publish(feedback);
  }

  const Vector3d top{0, 0, 1};
  std::string name = "viewer";
  std::map<std::string, InteractiveMarker> handles;
  std::vector<visualization_msgs::InteractiveMarkerPose> put_back;
  int resets = 0;

 private:
  ros::NodeHandle nh_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  interactive_markers::InteractiveMarkerClient client_;
  ros::Publisher feedback_;
};

/// What is drawn, by namespace and id, as a viewer keeps it.
class Picture {
 public:
  Picture() {
    const boost::function<void(const MarkerArray&)> receive = [this](const MarkerArray& message) {
      ++messages;
      for (const Marker& marker : message.markers) {
        std::map<int, Marker>& group = markers[marker.ns];
        if (marker.action == Marker::DELETE)
          group.erase(marker.id);
        else
          group[marker.id] = marker;
      }
    };
    subscriber_ = nh_.subscribe<MarkerArray>("rigid_body_node/markers", 1000, receive);
  }

  std::size_t count(const std::string& name_space) const {
    const auto found = markers.find(name_space);
    return found == markers.end() ? 0 : found->second.size();
  }

  std::map<std::string, std::map<int, Marker>> markers;
  int messages = 0;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
};

class Rviz : public NodeBesideCore {
 protected:
  /// Steps until a condition holds; false after a generous number.
  bool stepUntil(const std::function<bool()>& condition) {
    for (int i = 0; i < 2000; ++i) {
      driver.step(1);
      if (NodeDriver::waitFor(condition, 0.005)) return true;
    }
    return false;
  }

  Vector3d topOfCanary() const {
    const Motion canary = driver.motion("canary");
    return canary.position + canary.attitude * viewer.top;
  }

  void send(int event, const Vector3d& mouse_W) {
    viewer.send(event, driver.odometry("canary"), mouse_W);
  }

  /// Presses on the canary and drags until it is near the goal.
  void drag(const Vector3d& goal_W) {
    ASSERT_TRUE(stepUntil([&] { return viewer.isReady(); }));
    send(InteractiveMarkerFeedback::POSE_UPDATE, topOfCanary());
    send(InteractiveMarkerFeedback::MOUSE_DOWN, topOfCanary());
    EXPECT_TRUE(stepUntil([&] {
      send(InteractiveMarkerFeedback::POSE_UPDATE, goal_W);
      // its weight stretches the spring by 0.26 m: 9.8 N over 100 times the 0.375 kg of the top
      return (topOfCanary() - goal_W).norm() < 0.5;
    }));
  }

  /// Expects that the canary is under nothing but the scene's gravity.
  void expectFreeFall() {
    const auto velocity = [&] {
      driver.step(1);
      return Vector3d(driver.motion("canary").attitude * driver.motion("canary").linear_B);
    };
    const Vector3d before = velocity();
    const Vector3d gained = velocity() - before;
    EXPECT_LT((gained - 0.01 * Vector3d(0.1, 0, -9.80665)).norm(), 1e-12);
  }

  Viewer viewer;
};

}  // namespace

TEST_F(Rviz, ArrowsComeWithWrenchesAndGoWithThem) {
  Picture picture;
  // the bodies, latched: nothing has moved since the node knew of the subscriber
  ASSERT_TRUE(NodeDriver::waitFor([&] { return picture.messages > 0; }));
  EXPECT_EQ(picture.count("box"), 1U);
  EXPECT_EQ(picture.count("wrench/force"), 0U);

  ASSERT_TRUE(stepUntil([&] { return picture.count("motion/trail") == 2; }));
  EXPECT_EQ(picture.count("motion/angular_momentum"), 1U);  // the canary does not turn
  EXPECT_EQ(picture.count("wrench/force"), 0U);

  AppliedWrench message = generalMessage();
  message.duration = ros::Duration(0.2);
  general.publish(message);
  Marker arrow;
  ASSERT_TRUE(stepUntil([&] {
    if (picture.count("wrench/force") == 1) arrow = picture.markers["wrench/force"][0];
    return arrow.header.stamp == driver.odometry("box").header.stamp;
  }));
  EXPECT_EQ(picture.count("wrench/couple"), 1U);
  EXPECT_EQ(arrow.header.frame_id, "world");
  const Vector3d along = fromPoint(arrow.points.at(1)) - fromPoint(arrow.points.at(0));
  EXPECT_LT(along.normalized().cross(F.normalized()).norm(), 1e-12);
  const Motion box = driver.motion("box");
  EXPECT_LT((fromPoint(arrow.points.at(0)) - box.position - box.attitude * point).norm(), 1e-12);

  ASSERT_TRUE(stepUntil([&] { return picture.count("wrench/force") == 0; }));
  EXPECT_EQ(picture.count("wrench/couple"), 0U);
}

TEST_F(Rviz, WhoComesLateIsSentTheBodiesAndNotWhatWasDrawnLast) {
  const auto bodies_come = [this] {
    const Picture picture;
    EXPECT_TRUE(NodeDriver::waitFor([&] { return picture.messages > 0; }));
    EXPECT_EQ(picture.count("box"), 1U);
    EXPECT_EQ(picture.count("canary"), 1U);
    EXPECT_EQ(picture.count("motion/trail"), 0U);
    EXPECT_TRUE(stepUntil([&] { return picture.count("motion/trail") == 2; }));
  };
  bodies_come();
  bodies_come();
}

TEST_F(Rviz, ADraggedHandlePullsItsBodyAndIsPutBack) {
  const Vector3d goal_W = topOfCanary() + Vector3d(2, 0, 0);
  drag(goal_W);
  ASSERT_EQ(viewer.handles.size(), 2U);
  EXPECT_EQ(viewer.handles["canary"].header.frame_id, "canary");
  EXPECT_TRUE(viewer.put_back.empty());

  send(InteractiveMarkerFeedback::MOUSE_UP, goal_W);
  ASSERT_TRUE(NodeDriver::waitFor([&] { return viewer.isPutBack(); }));
  EXPECT_EQ(viewer.put_back[0].name, "canary");
  EXPECT_EQ(viewer.put_back[0].header.frame_id, "canary");
  EXPECT_EQ(fromPoint(viewer.put_back[0].pose.position), Vector3d::Zero());
  EXPECT_EQ(viewer.resets, 0);
  expectFreeFall();
}

TEST_F(Rviz, ClearWrenchesAndResetMakeTheMouseLetGo) {
  const auto clear = [] {
    ClearWrenches call;
    return ros::service::call("rigid_body_node/clear_wrenches", call) && call.response.success;
  };
  const auto reset = [this] {
    driver.reset();
    return true;
  };
  for (const auto& end : std::vector<std::function<bool()>>{clear, reset}) {
    const Vector3d goal_W = topOfCanary() + Vector3d(2, 0, 0);
    drag(goal_W);
    ASSERT_TRUE(end());
    send(InteractiveMarkerFeedback::POSE_UPDATE, goal_W);
    // the release by another viewer ends nothing; its answer tells that the feedback is in
    viewer.put_back.clear();
    viewer.name = "other";
    send(InteractiveMarkerFeedback::MOUSE_UP, goal_W);
    ASSERT_TRUE(NodeDriver::waitFor([&] { return viewer.isPutBack(); }));
    viewer.name = "viewer";
    expectFreeFall();
  }
}

}  // namespace rigid_body_sim
