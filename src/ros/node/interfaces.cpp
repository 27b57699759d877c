#include "ros/node/interfaces.hpp"

#include <set>

#include <ros/names.h>
#include <ros/this_node.h>

namespace rigid_body_sim {
namespace {

// roscpp tells a node its topics, not its services
const char* const kServices =
    "~apply_wrench, ~apply_wrenches, ~clear_wrenches, ~get_state, ~load, ~pause, ~reset, ~save, "
    "~set_mass_properties, ~set_present, ~set_real_time_factor, ~set_state, ~step";

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> withoutLog(std::vector<std::string> names) {
  std::vector<std::string> kept;
  for (std::string& name : names)
    if (name != "/rosout") kept.push_back(std::move(name));
  return kept;
}

}  // namespace

std::vector<std::string> shortNames(const std::vector<std::string>& names, const std::string& node,
                                    const std::vector<std::string>& bodies) {
  std::set<std::string> spaces;
  for (const std::string& body : bodies) spaces.insert(ros::names::resolve(body) + "/");
  std::set<std::string> shortened;
  for (const std::string& name : names) {
    // the longest name of a body that begins it: <body>/<imu>/truth has two levels
    std::size_t end = name.rfind('/') + 1;
    while (end > 1 && spaces.count(name.substr(0, end)) == 0) end = name.rfind('/', end - 2) + 1;
    if (end > 1)
      shortened.insert("<body>/" + name.substr(end));
    else if (name.rfind(node + "/", 0) == 0)
      shortened.insert("~" + name.substr(node.size() + 1));
    else
      shortened.insert(name);
  }
  return {shortened.begin(), shortened.end()};
}

std::vector<std::string> interfaceLines(const std::vector<std::string>& bodies) {
  const std::string& node = ros::this_node::getName();
  const auto listed = [&](const std::vector<std::string>& names) {
    return joined(shortNames(withoutLog(names), node, bodies));
  };
  std::vector<std::string> subscribed, published;
  ros::this_node::getSubscribedTopics(subscribed);
  ros::this_node::getAdvertisedTopics(published);
  return {"subscribes to " + listed(subscribed), "publishes " + listed(published),
          "serves " + std::string(kServices) + " (~ is " + node + "/)"};
}

}  // namespace rigid_body_sim
