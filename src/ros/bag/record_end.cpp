#include "ros/bag/record_end.hpp"

#include <algorithm>
#include <stdexcept>

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>

#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/Input.h>
#include <rigid_body_sim/LawForces.h>

#include "ros/bag/open_bag.hpp"

namespace rigid_body_sim {
namespace {

/// Commands and what actuators do are of one type.
bool isCommandTopic(const std::string& topic) {
  const std::string name = "/command";
  return topic.size() >= name.size() && topic.substr(topic.size() - name.size()) == name;
}

/// The stamp of what a node says of an instant of its run; nothing of any other message. Wall time,
/// at which messages were recorded, goes on while a run is paused or runs at a pace of its own.
std::optional<ros::Time> stampOfRun(const rosbag::MessageInstance& message) {
  if (const auto odometry = message.instantiate<nav_msgs::Odometry>())
    return odometry->header.stamp;
  if (const auto states = message.instantiate<BodyStates>()) return states->header.stamp;
  if (const auto contacts = message.instantiate<Contacts>()) return contacts->header.stamp;
  if (const auto forces = message.instantiate<LawForces>()) return forces->header.stamp;
  if (const auto imu = message.instantiate<sensor_msgs::Imu>()) return imu->header.stamp;
  if (const auto actuators = message.instantiate<sensor_msgs::JointState>())
    if (!isCommandTopic(message.getTopic())) return actuators->header.stamp;
  if (const auto clock = message.instantiate<rosgraph_msgs::Clock>()) return clock->clock;
  return std::nullopt;
}

bool isOfLaterRun(const rosbag::MessageInstance& message) {
  const Input::ConstPtr input = message.instantiate<Input>();
  return input && input->run > 0;
}

std::optional<double> recordEnd(const rosbag::Bag& bag, const TimeOrigin& origin) {
  std::optional<double> end;
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) {
    if (isOfLaterRun(message)) return std::nullopt;
    const std::optional<ros::Time> stamp = stampOfRun(message);
    if (!stamp) continue;
    const double t = origin.simulationTime(*stamp);
    end = std::max(end.value_or(t), t);
  }
  return end;
}

}  // namespace

std::optional<double> recordEnd(const std::string& path, const TimeOrigin& origin) {
  try {
    rosbag::Bag bag;
    openBag(path, bag);
    return recordEnd(bag, origin);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
