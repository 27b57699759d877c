#include "ros/bag/record_end.hpp"

#include <algorithm>
#include <stdexcept>

#include <geometry_msgs/WrenchStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>

#include <rigid_body_sim/AppliedWrenches.h>
#include <rigid_body_sim/Input.h>

namespace rigid_body_sim {
namespace {

/// Commands and what actuators do are of one type.
bool isCommandTopic(const std::string& topic) {
  const std::string name = "/command";
  return topic.size() >= name.size() && topic.substr(topic.size() - name.size()) == name;
}

bool isInput(const rosbag::MessageInstance& message) {
  namespace traits = ros::message_traits;
  const std::string type = message.getDataType();
  if (type == traits::datatype<sensor_msgs::JointState>())
    return isCommandTopic(message.getTopic());
  return type == traits::datatype<Input>() || type == traits::datatype<AppliedWrench>() ||
         type == traits::datatype<AppliedWrenches>() ||
         type == traits::datatype<geometry_msgs::WrenchStamped>();
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
    if (isInput(message)) continue;
    const double t = origin.simulationTime(message.getTime());
    end = std::max(end.value_or(t), t);
  }
  return end;
}

}  // namespace

std::optional<double> recordEnd(const std::string& path, const TimeOrigin& origin) {
  try {
    rosbag::Bag bag;
    bag.open(path, rosbag::bagmode::Read);
    return recordEnd(bag, origin);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
