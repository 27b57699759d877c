#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/Imu.h>

#include "support/simulate_bags.hpp"

namespace rigid_body_sim {
namespace {

struct ImuRow {
  double time = 0;
  std::string body, imu;
  std::vector<double> values;  // gx, gy, gz, ax, ay, az
};

class SimulateImu : public test::SimulateBags {
 protected:
  /// A box that turns and is pushed at 0.1 s, within a step; a post.
  std::string imuScene() const {
    return directory.written("scene.yaml", R"(
time_step: 0.008
gravity: [0, 0, -9.80665]
bodies: [{name: box, shape: {box: [1, 2, 3]}, mass: 2,
          twist: {frame: world, linear: [0, 0, 0], angular: [0, 0, 2]},
          imus: {imu: {position: [0.5, 0, 0], rate: 200, accelerometer: {noise_density: 1}},
                 slow: {rate: 3}}},
         {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true, imus: {imu: {rate: 10}}}]
wrenches: [{body: box, frame: world, force: [0, 0, 6], start: 0.1, duration: .inf}]
)");
  }

  std::vector<ImuRow> rows(const std::string& name) const {
    std::ifstream file(path(name));
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "time,body,imu,gx,gy,gz,ax,ay,az");
    std::vector<ImuRow> all;
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      ImuRow row;
      std::string cell;
      std::getline(cells, cell, ',');
      row.time = std::stod(cell);
      std::getline(cells, row.body, ',');
      std::getline(cells, row.imu, ',');
      while (std::getline(cells, cell, ',')) row.values.push_back(std::stod(cell));
      EXPECT_EQ(row.values.size(), 6U);
      all.push_back(row);
    }
    return all;
  }
};

}  // namespace

TEST_F(SimulateImu, WritesEverySampleWithoutNoise) {
  ASSERT_EQ(simulate(imuScene() + " --duration 1 --imu-csv " + path("imu.csv")), 0) << said;
  std::map<std::string, int> counts;
  double last = 0;
  for (const ImuRow& row : rows("imu.csv")) {
    const int k = counts[row.body + "/" + row.imu]++;
    const double rate = row.body == "post" ? 10 : row.imu == "slow" ? 3 : 200;
    EXPECT_EQ(row.time, k / rate);
    EXPECT_GE(row.time, last);
    last = row.time;
    const bool on_post = row.body == "post";
    EXPECT_NEAR(row.values[2], on_post ? 0 : 2, 1e-14);
    EXPECT_NEAR(row.values[3], row.imu == "imu" && !on_post ? -4 * 0.5 : 0, 1e-13);
    EXPECT_NEAR(row.values[5], on_post ? 9.80665 : row.time >= 0.1 ? 3 : 0, 1e-13);
  }
  EXPECT_EQ(counts,
            (std::map<std::string, int>{{"box/imu", 201}, {"box/slow", 4}, {"post/imu", 11}}));
}

TEST_F(SimulateImu, TruthInTheBagIsThatOfTheTable) {
  ASSERT_EQ(simulate(imuScene() + " --duration 0.5 --sample 0.25 --imu-csv " + path("imu.csv") +
                     " --bag " + path("run.bag")),
            0)
      << said;
  std::vector<ImuRow> expected;
  for (const ImuRow& row : rows("imu.csv"))
    if (row.body == "box" && row.imu == "imu") expected.push_back(row);
  rosbag::Bag bag(path("run.bag"), rosbag::bagmode::Read);
  std::size_t k = 0, noisy = 0;
  for (const rosbag::MessageInstance& instance : rosbag::View(bag)) {
    const auto message = instance.instantiate<sensor_msgs::Imu>();
    if (instance.getTopic() == "/box/imu") noisy += message->linear_acceleration.y != 0;
    if (instance.getTopic() != "/box/imu/truth") continue;
    ASSERT_LT(k, expected.size());
    EXPECT_EQ(message->header.stamp, ros::Time(expected[k].time));
    EXPECT_EQ(message->angular_velocity.z, expected[k].values[2]);
    EXPECT_EQ(message->linear_acceleration.x, expected[k].values[3]);
    EXPECT_EQ(message->linear_acceleration.z, expected[k].values[5]);
    ++k;
  }
  EXPECT_EQ(k, 101U);
  EXPECT_EQ(noisy, 101U);
}

TEST_F(SimulateImu, EndsWithASampleWithinAStep) {
  ASSERT_EQ(simulate(imuScene() + " --duration 0.0301 --imu-csv " + path("imu.csv")), 0) << said;
  const std::vector<ImuRow> all = rows("imu.csv");
  EXPECT_EQ(all.back().time, 0.03);
}

TEST_F(SimulateImu, RefusesWhatItCannotWrite) {
  const std::string without = scene() + " --duration 0.1";
  EXPECT_EQ(simulate(without + " --imu-csv " + path("imu.csv")), 2);
  EXPECT_EQ(said,
            "simulate: --imu-csv goes with a scene in which a body has imus (simulate --help)\n");
  const std::string with = imuScene() + " --duration 0.1";
  EXPECT_EQ(simulate(with + " --csv - --imu-csv -"), 2);
  EXPECT_EQ(simulate(with + " --imu-csv /nowhere/imu.csv"), 1);
  EXPECT_EQ(simulate(with + " --imu-csv " + path("x") + " --csv " + path("x")), 2) << said;
  EXPECT_EQ(simulate(with + " --imu-csv " + path("scene.yaml")), 2) << said;
}

}  // namespace rigid_body_sim
