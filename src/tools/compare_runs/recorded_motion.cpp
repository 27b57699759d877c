#include "tools/compare_runs/recorded_motion.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "scene/message_text.hpp"
#include "tools/common/csv_header.hpp"

namespace rigid_body_sim {
namespace {

Motion motionOf(const nav_msgs::Odometry& message) {
  const auto& [position, orientation] = message.pose.pose;
  const auto& [linear, angular] = message.twist.twist;
  return {position.x,    position.y,    position.z, orientation.x, orientation.y,
          orientation.z, orientation.w, linear.x,   linear.y,      linear.z,
          angular.x,     angular.y,     angular.z};
}

RecordedMotion motionOfBag(const std::string& path) {
  rosbag::Bag bag;
  bag.open(path, rosbag::bagmode::Read);
  RecordedMotion motion;
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<nav_msgs::Odometry>()));
  for (const rosbag::MessageInstance& instance : view) {
    const auto message = instance.instantiate<nav_msgs::Odometry>();
    if (!message) throw std::runtime_error(instance.getTopic() + " is of another version");
    motion[message->child_frame_id][static_cast<std::int64_t>(message->header.stamp.toNSec())] =
        motionOf(*message);
  }
  if (motion.empty()) throw std::runtime_error("holds no odometry (nav_msgs/Odometry)");
  return motion;
}

double numberOf(const std::string& field) {
  char* end = nullptr;
  const double number = std::strtod(field.c_str(), &end);
  if (field.empty() || *end != '\0' || !std::isfinite(number))
    throw std::runtime_error("a finite number is expected, got '" + printable(field) + "'");
  return number;
}

void addRow(const std::string& row, RecordedMotion& motion) {
  std::vector<std::string> fields;
  std::istringstream stream(row);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  Motion state{};
  if (fields.size() != state.size() + 2)
    throw std::runtime_error("15 fields are expected, got " + std::to_string(fields.size()));
  for (std::size_t i = 0; i < state.size(); ++i) state[i] = numberOf(fields[i + 2]);
  constexpr double kMaxSeconds = 9e9;  // that 64 bits of nanoseconds hold
  const double time = numberOf(fields[0]);
  if (std::abs(time) > kMaxSeconds) throw std::runtime_error("time must be at most 9e9 s");
  motion[fields[1]][std::llround(time * 1e9)] = state;
}

RecordedMotion motionOfCsv(const std::string& path) {
  std::ifstream file(path);
  std::string row;
  if (!file.is_open()) throw std::runtime_error(std::strerror(errno));
  std::getline(file, row);
  if (row != kCsvHeader)
    throw std::runtime_error("neither a bag (.bag) nor a CSV file of simulate: line 1 must be " +
                             std::string(kCsvHeader));
  RecordedMotion motion;
  for (int line = 2; std::getline(file, row); ++line) {
    try {
      addRow(row, motion);
    } catch (const std::exception& fault) {
      throw std::runtime_error("line " + std::to_string(line) + ": " + fault.what());
    }
  }
  return motion;
}

}  // namespace

bool isBag(const std::string& path) {
  constexpr const char* kExtension = ".bag";
  return path.size() >= 4 && path.compare(path.size() - 4, 4, kExtension) == 0;
}

RecordedMotion readMotion(const std::string& path) {
  try {
    return isBag(path) ? motionOfBag(path) : motionOfCsv(path);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
