#pragma once

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <sys/wait.h>

#include <rigid_body_sim/Input.h>

#include "support/temporary_directory.hpp"

namespace rigid_body_sim::test {

/// Runs of `simulate` with bags, each test in a directory of its own.
class SimulateBags : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return directory.path(name); }

  std::string scene(const std::string& wrenches = "") const {
    return directory.written("scene.yaml", R"(
time_step: 0.004
bodies: [{name: box, shape: {box: [1, 2, 3]}, mass: 2,
          twist: {frame: world, linear: [0, 0, 0], angular: [1, 2, 0.1]},
          points: {tip: {position: [0, 0, 1.5]}}},
         {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}]
)" + wrenches);
  }

  /// Exit code of `simulate`; what it says is in `said`.
  int simulate(const std::string& arguments) {
    const std::string command =
        std::string(RIGID_BODY_SIM_SIMULATE) + " " + arguments + " >" + path("said") + " 2>&1";
    const int status = WEXITSTATUS(std::system(command.c_str()));
    said = content("said");
    return status;
  }

  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }

  /// Writes a bag with an input of 1 N at each of the times [s], 4 ms a step, held for 0.5 s, as a
  /// node publishes them that was started at `start`.
  /// late [s]: what each was to act from before it was taken.
  void record(const std::string& name, const std::vector<double>& times, ros::Time start,
              double late = 0) const {
    rosbag::Bag bag(path(name), rosbag::bagmode::Write);
    for (std::size_t i = 0; i < times.size(); ++i) {
      Input input;
      input.header.frame_id = "world";
      input.header.stamp = start + ros::Duration(times[i]);
      input.number = i;
      input.step = static_cast<std::uint64_t>(std::llround(times[i] / 0.004));
      input.time = static_cast<double>(input.step) * 0.004;
      input.body = input.point_frame = "box";
      input.wrench.force.x = 1;
      input.start = input.time - late;
      input.end = input.start + 0.5;
      // a recorder receives it a little later
      bag.write("/rigid_body_node/inputs", input.header.stamp + ros::Duration(0.0003), input);
    }
  }

  TemporaryDirectory directory;
  std::string said;
};

}  // namespace rigid_body_sim::test
