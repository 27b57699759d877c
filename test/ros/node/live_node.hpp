#pragma once

#include <string>

#include <gtest/gtest.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetRealTimeFactor.h>
#include <rigid_body_sim/Step.h>

#include "node_driver.hpp"
#include "ros/mouse/menu.hpp"

namespace rigid_body_sim {

/// What a user changes about a node while it runs.
class LiveNode : public ::testing::Test {
 protected:
  template <class Service>
  static typename Service::Response call(const std::string& name,
                                         const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(ros::service::call("rigid_body_node/" + name, service));
    return service.response;
  }

  /// Returns the rule that the factor breaks; empty if none.
  static std::string setFactor(double factor) {
    SetRealTimeFactor::Request request;
    request.factor = factor;
    return call<SetRealTimeFactor>("set_real_time_factor", request).message;
  }

  static GetState::Response boxNow() {
    GetState::Request request;
    request.body = "box";
    request.frame = "world";
    return call<GetState>("get_state", request);
  }

  static ros::Time now() { return boxNow().stamp; }

  /// Wall time [s] until a state of this stamp has come, from `begin` on.
  double elapsedAt(const ros::Time& stamp, const ros::WallTime& begin) const {
    EXPECT_TRUE(NodeDriver::waitFor([&] { return driver.stamps().back() >= stamp; }));
    return (ros::WallTime::now() - begin).toSec();
  }

  using Feedback = visualization_msgs::InteractiveMarkerFeedback;

  /// As rviz reports a choice in the menu of the box.
  void choose(MenuChoice choice) const {
    Feedback feedback;
    feedback.header.frame_id = feedback.marker_name = "box";
    feedback.client_id = "viewer";
    feedback.event_type = Feedback::MENU_SELECT;
    feedback.menu_entry_id = static_cast<std::uint32_t>(choice);
    menu.publish(feedback);
  }

  /// As ~step answers.
  static bool isPaused() { return call<Step>("step", Step::Request()).success; }

  ros::Publisher menu;
  NodeDriver driver{{"box", "canary"}};
};

}  // namespace rigid_body_sim
