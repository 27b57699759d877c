#include "tools/compare_runs/recorded_motion.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>

#include "ros/bag/in_file_order.hpp"
#include "ros/bag/open_bag.hpp"
#include "ros/bag/run_starts.hpp"
#include "scene/files/read_file.hpp"
#include "tools/common/csv_header.hpp"
#include "tools/common/csv_rows.hpp"
#include "tools/common/require_motion.hpp"

namespace rigid_body_sim {
namespace {

Motion motionOf(const nav_msgs::Odometry& message) {
  const auto& [position, orientation] = message.pose.pose;
  const auto& [linear, angular] = message.twist.twist;
  return {position.x,    position.y,    position.z, orientation.x, orientation.y,
          orientation.z, orientation.w, linear.x,   linear.y,      linear.z,
          angular.x,     angular.y,     angular.z};
}

/// A quaternion of zeros would be near any other.
Motion checkedMotionOf(const nav_msgs::Odometry& message, const std::string& topic) {
  const Motion motion = motionOf(message);
  try {
    requireMotion(motion);
  } catch (const std::exception& fault) {
    throw std::runtime_error(topic + ": " + fault.what());
  }
  return motion;
}

/// A node repeats what it said while time stands.
void add(const Motion& motion, std::vector<Motion>& of_instant) {
  const auto known = std::find_if(of_instant.begin(), of_instant.end(),
                                  [&](const Motion& m) { return haveSameBits(m, motion); });
  if (known == of_instant.end()) of_instant.push_back(motion);
}

RecordedMotion motionOfBag(const std::string& path) {
  rosbag::Bag bag;
  openBag(path, bag);
  RecordedMotion motion;
  RunStarts starts;
  inFileOrder(bag, [&](const rosbag::MessageInstance& instance) {
    if (instance.getDataType() != ros::message_traits::datatype<nav_msgs::Odometry>()) return;
    const auto message = instance.instantiate<nav_msgs::Odometry>();
    if (!message) throw std::runtime_error(instance.getTopic() + " is of another version");
    const ros::Time& stamp = message->header.stamp;
    if (starts.isStart(instance.getTopic(), stamp)) motion.bodies.clear();
    add(checkedMotionOf(*message, instance.getTopic()),
        motion.bodies[message->child_frame_id][static_cast<std::int64_t>(stamp.toNSec())]);
  });
  if (motion.bodies.empty()) throw std::runtime_error("holds no odometry (nav_msgs/Odometry)");
  if (starts.runs() > 1)
    motion.notice =
        path + ": holds several runs, separated by resets or loads, of which the last is compared";
  return motion;
}

void addRow(const CsvRow& row, RecordedMotion& motion) {
  constexpr double kMaxSeconds = 9e9;  // that 64 bits of nanoseconds hold
  if (std::abs(row.time) > kMaxSeconds) throw std::runtime_error("time must be at most 9e9 s");
  Motion state;
  std::copy(row.numbers.begin(), row.numbers.end(), state.begin());
  requireMotion(state);
  add(state, motion.bodies[row.body][std::llround(row.time * 1e9)]);
}

RecordedMotion motionOfCsv(const std::string& path) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    throw std::runtime_error("is a directory; a run is a bag or a CSV file");
  std::ifstream file(path);
  std::string row;
  if (!file.is_open()) throw std::runtime_error(openFault(path, errno));
  readCsvLine(file, row);
  if (row != kCsvHeader)
    throw std::runtime_error("neither a bag (.bag) nor a CSV file of simulate: line 1 must be " +
                             std::string(kCsvHeader));
  RecordedMotion motion;
  const std::string cut = readCsvRows(file, row, [&](const CsvRow& read) { addRow(read, motion); });
  if (!cut.empty()) throw std::runtime_error(cut + "; a run is compared as a whole");
  return motion;
}

}  // namespace

bool haveSameBits(const Motion& a, const Motion& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits, by which 0 and -0 differ
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

RecordedMotion readMotion(const std::string& path) {
  try {
    return isBag(path) ? motionOfBag(path) : motionOfCsv(path);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
