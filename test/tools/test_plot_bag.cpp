#include <cmath>
#include <filesystem>
#include <string>

#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>

#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/SimStatus.h>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "tools/plot/run_data.hpp"

namespace rigid_body_sim {
namespace {

class PlotBag : public ::testing::Test {
 protected:
  PlotBag() { bag.open(path, rosbag::bagmode::Write); }

  /// A quarter of a turn about z: the body's x axis is the world's y axis.
  nav_msgs::Odometry odometry(double t) const {
    nav_msgs::Odometry message;
    message.header.stamp = start + ros::Duration(t);
    message.child_frame_id = "box";
    message.pose.pose.position.x = t;
    message.pose.pose.orientation.z = message.pose.pose.orientation.w = std::sqrt(0.5);
    message.twist.twist.linear.x = 2;
    message.twist.twist.angular.x = 3;
    return message;
  }

  template <class Message>
  void write(const std::string& topic, const Message& message) {
    bag.write(topic, message.header.stamp, message);
  }

  RunData read() {
    bag.close();
    return readRun({path});
  }

  TemporaryDirectory files;
  std::string path = files.path("run.bag");
  rosbag::Bag bag;
  ros::Time start{1700000000, 250000000};
};

}  // namespace

TEST_F(PlotBag, TurnsVelocitiesIntoTheWorldAndCountsFromTheFirstStamp) {
  for (const double t : {0.0, 0.5}) write("/box/odom", odometry(t));
  const RunData run = read();
  EXPECT_EQ(run.begin, 1700000000.25);
  ASSERT_EQ(run.motion.all().size(), 1U);
  const Samples<13>& box = run.motion.all()[0].samples;
  EXPECT_EQ(box.t, (std::vector<double>{0, 0.5}));
  EXPECT_NEAR(box.rows[1][8], 2, 1e-12);   // vy
  EXPECT_NEAR(box.rows[1][11], 3, 1e-12);  // wy
}

TEST_F(PlotBag, KeepsTheTimeOfASimulatedClock) {
  start = ros::Time(0, 1);
  for (const double t : {0.0, 0.5}) write("/box/odom", odometry(t));
  EXPECT_EQ(read().begin, 0);
}

TEST_F(PlotBag, HoldsForcesAndTheBalanceOfItsTopics) {
  write("/box/odom", odometry(0));
  geometry_msgs::WrenchStamped wrench;
  wrench.header.stamp = start;
  wrench.header.frame_id = "box";
  wrench.wrench.force.x = 5;
  write("/box/applied_wrench", wrench);
  write("/box/wrench", wrench);  // an input, not what the simulation applied
  Contacts contacts;
  contacts.header.stamp = start;
  write("/rigid_body_node/contacts", contacts);  // nothing touches yet
  contacts.header.stamp = start + ros::Duration(0.5);
  contacts.contacts.resize(2);
  for (ContactState& contact : contacts.contacts) {
    contact.body = "box";
    contact.other = "ball";
    contact.normal_force.z = 4;
    contact.friction_force.x = 1;
  }
  write("/rigid_body_node/contacts", contacts);
  SimStatus status;
  status.header.stamp = start;
  status.energy_balance = std::nan("");  // nobody had subscribed
  write("/rigid_body_node/status", status);
  status.energy_balance = 1e-9;
  status.mechanical_energy = 7;
  write("/rigid_body_node/status", status);

  const RunData run = read();
  ASSERT_EQ(run.applied.all().size(), 1U);
  EXPECT_EQ(run.applied.all()[0].samples.rows, (std::vector<std::array<double, 6>>{{5, 0, 0}}));
  ASSERT_EQ(run.contact.all().size(), 2U);
  EXPECT_EQ(run.contact.all()[0].body, "ball");
  using Rows = std::vector<std::array<double, 3>>;
  EXPECT_EQ(run.contact.all()[0].samples.rows, (Rows{{0, 0, 0}, {-2, 0, -8}}));
  EXPECT_EQ(run.contact.all()[1].samples.rows, (Rows{{0, 0, 0}, {2, 0, 8}}));
  EXPECT_EQ(run.contact.all()[1].samples.t, (std::vector<double>{0, 0.5}));
  ASSERT_EQ(run.balance.rows.size(), 1U);
  EXPECT_EQ(run.balance.rows[0][0], 7);
  EXPECT_EQ(run.balance.rows[0][9], 1e-9);
  EXPECT_FALSE(run.has_kinetic);
}

// A reset of time, in the order in which a node says so on its topics: recorded at wall time, and
// at that of the node's clock, in whose order a view of rosbag mixes the runs.
class PlotBagOfRuns : public PlotBag, public ::testing::WithParamInterface<bool> {};

TEST_P(PlotBagOfRuns, IsReadFromTheLastOn) {
  ros::Time recorded = start;
  const auto say = [&](const std::string& topic, auto message) {
    recorded += ros::Duration(1);
    bag.write(topic, GetParam() ? recorded : message.header.stamp, message);
  };
  SimStatus status;
  const auto odom = [&](const std::string& body, double t) {
    nav_msgs::Odometry message = odometry(t);
    message.child_frame_id = body;
    say("/" + body + "/odom", message);
  };
  const auto energyAt = [&](double t, double energy) {
    status.header.stamp = start + ros::Duration(t);
    status.mechanical_energy = energy;
    say("/rigid_body_node/status", status);
  };
  for (const double t : {0.0, 1.0, 2.0}) odom("box", t), odom("top", t), odom("gone", t);
  energyAt(1.5, 7);
  odom("box", 0), odom("top", 0);
  energyAt(0.5, 8);
  odom("box", 1), odom("top", 1);
  const RunData run = read();
  EXPECT_EQ(run.notices,
            std::vector<std::string>{path + ": holds several runs, separated by resets or "
                                            "loads, of which the last is drawn"});
  ASSERT_EQ(run.motion.all().size(), 2U);
  for (const BodySamples<13>& body : run.motion.all())
    EXPECT_EQ(body.samples.t, (std::vector<double>{0, 1})) << body.body;
  ASSERT_EQ(run.balance.t.size(), 1U);
  EXPECT_EQ(run.balance.rows[0][0], 8);
}

INSTANTIATE_TEST_SUITE_P(Clocks, PlotBagOfRuns, ::testing::Bool(), [](const auto& at_wall_time) {
  return at_wall_time.param ? "wall" : "simulation";
});

TEST_F(PlotBag, WithoutABalanceSaysWhyEnergyIsNotDrawn) {
  write("/box/odom", odometry(0));
  const RunData without = read();
  EXPECT_EQ(without.notices,
            std::vector<std::string>{
                path +
                ": energy and momentum are not drawn, for it holds no status "
                "(rigid_body_sim/SimStatus): record ~status of the node, too, or draw the run with "
                "simulate --plot"});
  bag.open(path, rosbag::bagmode::Append);
  SimStatus status;
  status.header.stamp = start;
  status.energy_balance = std::nan("");
  write("/rigid_body_node/status", status);
  EXPECT_EQ(read().notices.at(0), path +
                                      ": energy and momentum are not drawn, for no status in it "
                                      "has a balance yet: record ~status for more than two "
                                      "seconds");
  bag.open(path, rosbag::bagmode::Append);
  status.energy_balance = 0;
  write("/rigid_body_node/status", status);
  EXPECT_TRUE(read().notices.empty());
}

TEST_F(PlotBag, ThatIsCutIsRefusedWithWhatToDo) {
  write("/box/odom", odometry(0));
  bag.close();
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 100);
  const test::Outcome run = test::runCommand(RIGID_BODY_SIM_PLOT " " + path + " 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.find("plot: " + path + ": the bag is cut: "), 0U) << run.out;
  EXPECT_NE(run.out.find("rosbag reindex"), std::string::npos) << run.out;
}

TEST_F(PlotBag, ThatHoldsNoMotionOrNoNumbersIsRefused) {
  const auto plotted = [&] {
    bag.close();
    return test::runCommand(RIGID_BODY_SIM_PLOT " " + path + " --out " + files.path(".") + " 2>&1");
  };
  test::Outcome run = plotted();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out,
            "plot: " + path + ": holds no odometry (nav_msgs/Odometry): record <body>/odom\n");
  bag.open(path, rosbag::bagmode::Write);
  nav_msgs::Odometry broken = odometry(0);
  broken.pose.pose.position.x = std::nan("");
  write("/box/odom", broken);
  run = plotted();
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "plot: " + path + ": /box/odom: position or velocity is not finite\n");
  const std::string text = files.written("text.bag", "no bag");
  run = test::runCommand(RIGID_BODY_SIM_PLOT " " + text + " 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out.find("plot: " + text + ": "), 0U) << run.out;
}

}  // namespace rigid_body_sim
