#include <sstream>
#include <string>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>

#include "support/run_command.hpp"
#include "support/simulate_bags.hpp"

/// Recorded runs in which a body leaves, comes in and becomes another.
namespace rigid_body_sim {
namespace {

class SimulatePresence : public test::SimulateBags {
 protected:
  std::string guestScene() const {
    return directory.written("scene.yaml", R"(
time_step: 0.004
gravity: [0, 0, -9.80665]
bodies: [{name: box, shape: {box: [1, 2, 3]}, mass: 2, imus: {imu: {rate: 250}},
          twist: {frame: world, linear: [0, 0, 0], angular: [1, 2, 0.1]}},
         {name: ball, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0]}]
forces: [{type: spring, from: {body: box}, to: {body: ball}, stiffness: 5, rest_length: 4}]
)");
  }

  static Input input(std::uint8_t kind, std::uint64_t number, std::uint64_t step) {
    Input message;
    message.kind = kind;
    message.number = number;
    message.step = step;
    message.time = static_cast<double>(step) * 0.004;
    message.header.frame_id = message.frame = "world";
    message.header.stamp = ros::Time(0, 1) + ros::Duration(message.time);
    message.body = "box";
    return message;
  }

  /// The box leaves at 0.1 s, comes in at 0.3 s, and has another mass from 0.4 s on.
  void recordGuest() const {
    Input enter = input(Input::ENTER, 1, 75);
    enter.pose.position.x = 1;
    enter.pose.orientation.w = 1;
    enter.twist.angular.z = 2;
    Input mass = input(Input::MASS, 2, 100);
    mass.inertia.m = 7;
    mass.inertia.com.y = 0.25;
    mass.inertia.ixx = mass.inertia.iyy = mass.inertia.izz = 3;
    rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Write);
    for (const Input& each : {input(Input::LEAVE, 0, 25), enter, mass})
      bag.write("/rigid_body_node/inputs", each.header.stamp, each);
  }

  /// The times [s] of the rows of a body in a CSV file.
  std::vector<double> timesOf(const std::string& body, const std::string& name) const {
    std::istringstream file(content(name));
    std::vector<double> times;
    for (std::string line; std::getline(file, line);)
      if (line.find("," + body + ",") != std::string::npos) times.push_back(std::stod(line));
    return times;
  }

  /// Whether a time lies where the box is absent. What is written at the instant of an input is the
  /// state before it.
  static bool isAbsent(double t) { return t > 0.1 + 1e-6 && t < 0.3 + 1e-6; }

  void expectGap(const std::string& name) const {
    const std::vector<double> box = timesOf("box", name);
    EXPECT_EQ(box.size(), 126U - 50U) << name;
    for (const double t : box) EXPECT_FALSE(isAbsent(t)) << name << ' ' << t;
  }
};

}  // namespace

TEST_F(SimulatePresence, WritesNothingOfABodyWhileItIsAbsent) {
  recordGuest();
  const test::Outcome run =
      test::runCommand("PATH=/nonexistent " RIGID_BODY_SIM_SIMULATE " " + guestScene() +
                       " --duration 0.5 --wrench-bag " + path("run.bag") + " --csv " +
                       path("run.csv") + " --imu-csv " + path("imu.csv") + " --plot " +
                       path("plots") + " --sample 0.004 --bag " + path("again.bag") + " 2>&1");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  for (const char* name : {"run.csv", "imu.csv", "plots/motion.csv", "plots/forces.csv"})
    expectGap(name);
  EXPECT_EQ(timesOf("ball", "run.csv").size(), 126U);
  std::size_t in_bag = 0;
  rosbag::Bag bag(path("again.bag"), rosbag::bagmode::Read);
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/box/odom"))) {
    EXPECT_FALSE(isAbsent(message.instantiate<nav_msgs::Odometry>()->header.stamp.toSec()));
    ++in_bag;
  }
  EXPECT_EQ(in_bag, 126U - 50U);
  EXPECT_NE(run.out.find("  changed by spring, set_mass_properties, set_present and weight: "),
            std::string::npos)
      << run.out;
}

// cut while the box is absent, and once its mass is another
TEST_F(SimulatePresence, GoesOnFromASavedStateWithTheSameRows) {
  recordGuest();
  const std::string replay = guestScene() + " --wrench-bag " + path("run.bag");
  ASSERT_EQ(simulate(replay + " --duration 0.2 --save " + path("away.state")), 0) << said;
  ASSERT_EQ(simulate(replay + " --duration 0.42 --save " + path("heavy.state")), 0) << said;
  ASSERT_EQ(simulate(replay + " --duration 0.6 --csv " + path("whole.csv")), 0) << said;
  ASSERT_EQ(simulate(guestScene() + " --load " + path("heavy.state") + " --duration 0.18 --csv " +
                     path("rest.csv")),
            0)
      << said;
  const std::string whole = content("whole.csv"), rest = content("rest.csv");
  const std::string rows = rest.substr(rest.find('\n') + 1);
  EXPECT_EQ(timesOf("box", "rest.csv").size(), 46U);
  EXPECT_EQ(whole.substr(whole.size() - rows.size()), rows);
  ASSERT_EQ(simulate(guestScene() + " --load " + path("away.state") + " --duration 0.08 --csv " +
                     path("rest.csv")),
            0)
      << said;
  EXPECT_TRUE(timesOf("box", "rest.csv").empty());
  EXPECT_EQ(timesOf("ball", "rest.csv").size(), 21U);
  EXPECT_NE(said.find("box: absent\n"), std::string::npos) << said;
  EXPECT_NE(said.find("ball: gravity, spherical, exact\n"), std::string::npos) << said;
  EXPECT_NE(said.find("  conserved: "), std::string::npos) << said;  // the spring rests
}

}  // namespace rigid_body_sim
