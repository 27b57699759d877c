#include <cmath>
#include <map>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <std_srvs/SetBool.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/ClearWrenches.h>
#include <rigid_body_sim/SimStatus.h>
#include <rigid_body_sim/Step.h>

#include "node_beside_core.hpp"

namespace rigid_body_sim {
namespace {

using diagnostic_msgs::DiagnosticStatus;

class MonitorTopics : public NodeBesideCore {
 protected:
  MonitorTopics() {
    const boost::function<void(const SimStatus&)> receive_status =
        [this](const SimStatus& message) { status = message; };
    const boost::function<void(const diagnostic_msgs::DiagnosticArray&)> receive_diagnostics =
        [this](const diagnostic_msgs::DiagnosticArray& message) {
          for (const DiagnosticStatus& s : message.status) {
            diagnostics[s.name] = s;
            ++reports[s.name];
          }
        };
    subscribers.push_back(nh.subscribe<SimStatus>("rigid_body_node/status", 100, receive_status));
    subscribers.push_back(
        nh.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, receive_diagnostics));
  }

  bool waitForLevel(const std::string& node, unsigned char level) {
    const std::string name = node + ": simulation";
    return NodeDriver::waitFor(
        [&] { return diagnostics.count(name) && diagnostics[name].level == level; });
  }

  SimStatus status;
  std::map<std::string, DiagnosticStatus> diagnostics;
  std::map<std::string, int> reports;
  std::vector<ros::Subscriber> subscribers;
};

}  // namespace

TEST_F(MonitorTopics, StatusIsPublishedWhilePausedToo) {
  const ros::Time reached = driver.step(10);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.header.stamp == reached; }));
  EXPECT_EQ(status.header.frame_id, "world");
  EXPECT_TRUE(status.paused);
  EXPECT_GE(status.steps, 10U);
  EXPECT_EQ(status.time, static_cast<double>(status.steps) * 0.01);
  EXPECT_GT(status.mechanical_energy, 0);
  EXPECT_EQ(status.attitude_error, 0);  // all of it is solved
  EXPECT_EQ(status.active_wrenches, 0U);

  AppliedWrench message = generalMessage();
  message.duration = ros::Duration(100);
  general.publish(message);
  message.duration = ros::Duration(-1);
  general.publish(message);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.refused >= 1; }));
  EXPECT_EQ(status.active_wrenches, 1U);

  // listened to, and so balanced
  driver.step(100);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.work != 0; }));
  EXPECT_LT(std::abs(status.energy_balance), 1e-9);

  driver.pause(false);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return !status.paused && status.real_time_factor > 0; }));
  driver.pause(true);
}

// diagnostic_updater's parameter is taken, and would let a thousand seconds pass
TEST_F(MonitorTopics, AreSentOnceASecondWhateverDiagnosticPeriodSays) {
  double period = 0;
  ASSERT_TRUE(ros::param::get("pad/diagnostic_period", period));
  ASSERT_EQ(period, 1000);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return reports["pad: simulation"] >= 3; }));
}

TEST_F(MonitorTopics, DivergenceIsAnErrorThatNamesWhatWhereAndWhen) {
  ASSERT_TRUE(waitForLevel("rigid_body_node", DiagnosticStatus::OK));
  ASSERT_TRUE(waitForLevel("pad", DiagnosticStatus::OK));
  const std::string& told = diagnostics["pad: simulation"].message;

  // paused: it stays, at the last finite state
  Step step;
  step.request.steps = 1000;
  ASSERT_TRUE(ros::service::call("pad/step", step));
  EXPECT_FALSE(step.response.success);
  ASSERT_TRUE(waitForLevel("pad", DiagnosticStatus::ERROR));
  EXPECT_EQ(told, "diverged: " + step.response.message);
  EXPECT_NE(told.find("body 'rocket'"), std::string::npos) << told;
  EXPECT_NE(told.find("t = "), std::string::npos) << told;
  EXPECT_NE(told.find("no longer finite"), std::string::npos) << told;

  // without the wrench it goes on
  ClearWrenches clear;
  ASSERT_TRUE(ros::service::call("pad/clear_wrenches", clear));
  step.request.steps = 1;
  ASSERT_TRUE(ros::service::call("pad/step", step));
  EXPECT_TRUE(step.response.success) << step.response.message;
  EXPECT_TRUE(waitForLevel("pad", DiagnosticStatus::OK));
}

TEST_F(MonitorTopics, DivergenceIsReportedBeforeTheNodeEnds) {
  ASSERT_TRUE(waitForLevel("pad", DiagnosticStatus::OK));
  AppliedWrench message = generalMessage();
  message.body = "rocket";
  message.wrench.force.x = 1e300;
  message.duration = ros::Duration(1000);
  ApplyWrench apply;
  apply.request.wrench = message;
  ASSERT_TRUE(ros::service::call("pad/apply_wrench", apply));
  ASSERT_TRUE(apply.response.success) << apply.response.message;
  std_srvs::SetBool resume;
  ASSERT_TRUE(ros::service::call("pad/pause", resume));
  EXPECT_TRUE(waitForLevel("pad", DiagnosticStatus::ERROR));
  EXPECT_NE(diagnostics["pad: simulation"].message.find("body 'rocket'"), std::string::npos);
}

}  // namespace rigid_body_sim
