#include "ros/options/node_options.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <sstream>

#include <ros/names.h>
#include <ros/param.h>
#include <ros/this_node.h>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

using XmlRpc::XmlRpcValue;

std::string quoted(const XmlRpcValue& value) {
  std::ostringstream text;
  if (value.getType() == XmlRpcValue::TypeBoolean)
    text << std::boolalpha << static_cast<const bool&>(value);
  else
    value.write(text);
  return "'" + printable(text.str()) + "'";
}

[[noreturn]] void refuse(const std::string& name, const XmlRpcValue& value,
                         const std::string& rule) {
  throw ParameterError("parameter ~" + name + ": must be " + rule + ", got " + quoted(value),
                       {name});
}

std::string readText(const std::string& name, const XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeString || static_cast<const std::string&>(value).empty())
    refuse(name, value, "a string that is not empty");
  return static_cast<const std::string&>(value);
}

std::string readPath(const std::string& name, const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeString &&
      static_cast<const std::string&>(value).find('\n') != std::string::npos)
    refuse(name, value, "a path; the text of a scene goes to ~scene");
  return readText(name, value);
}

/// Every scene is a mapping, in which a key ends with a colon.
std::string readSceneText(const std::string& name, const XmlRpcValue& value) {
  std::string text = readText(name, value);
  if (text.find(':') == std::string::npos)
    refuse(name, value, "the YAML text of a scene; a path belongs in ~scene_file");
  return text;
}

/// Without the slashes at its ends, which frames of tf2 do not have.
std::string readPrefix(const std::string& name, const XmlRpcValue& value) {
  constexpr char kRule[] = "a name as of a ROS node, such as robot_1";
  if (value.getType() != XmlRpcValue::TypeString) refuse(name, value, kRule);
  std::string prefix = static_cast<const std::string&>(value);
  prefix.erase(0, prefix.find_first_not_of('/'));
  prefix.erase(prefix.find_last_not_of('/') + 1);
  std::string fault;
  const bool is_name =
      ros::names::validate(prefix, fault) && prefix.find("//") == std::string::npos;
  if (!prefix.empty() && !is_name) refuse(name, value, kRule);
  return prefix;
}

/// A list, or a text of names separated by commas or blanks, as launch files and command lines have
/// it.
std::vector<std::string> readTopics(const std::string& name, const XmlRpcValue& value) {
  std::string text;
  const auto add = [&](const XmlRpcValue& item) {
    if (item.getType() != XmlRpcValue::TypeString)
      refuse(name, value, "names of topics, as a list or separated by commas");
    text += static_cast<const std::string&>(item) + " ";
  };
  if (value.getType() != XmlRpcValue::TypeArray) {
    add(value);
  } else {
    // NOLINTNEXTLINE(modernize-loop-convert): begin() goes through the members of a struct
    for (int i = 0; i < value.size(); ++i) add(value[i]);
  }
  for (char& c : text)
    if (c == ',' || c == '[' || c == ']') c = ' ';
  std::istringstream words(text);
  std::vector<std::string> topics;
  std::string fault;
  for (std::string topic; words >> topic; topics.push_back(topic))
    if (!ros::names::validate(topic, fault))
      refuse(name, value, "names of topics, as a list or separated by commas");
  return topics;
}

bool readBool(const std::string& name, const XmlRpcValue& value) {
  if (value.getType() != XmlRpcValue::TypeBoolean) refuse(name, value, "true or false");
  return static_cast<const bool&>(value);
}

/// NaN unless the value is a number.
double number(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<const int&>(value);
  if (value.getType() == XmlRpcValue::TypeDouble) return static_cast<const double&>(value);
  return std::nan("");
}

double readRate(const std::string& name, const XmlRpcValue& value) {
  const double x = number(value);
  if (!(x > 0) || !(x <= NodeOptions::kMaxRate))
    refuse(name, value, "a number > 0 and at most 1e9, as stamps are whole nanoseconds");
  return x;
}

double readNotNegative(const std::string& name, const XmlRpcValue& value) {
  const double x = number(value);
  if (!std::isfinite(x) || !(x >= 0)) refuse(name, value, "a finite number >= 0");
  return x;
}

/// One number for all six axes, or six.
std::array<double, 6> readDiagonal(const std::string& name, const XmlRpcValue& value) {
  constexpr char kRule[] = "a finite number >= 0, or a list of six (x, y, z, rotation about each)";
  std::array<double, 6> diagonal;
  if (value.getType() != XmlRpcValue::TypeArray) {
    diagonal.fill(number(value));
  } else {
    if (value.size() != 6) refuse(name, value, kRule);
    for (int i = 0; i < 6; ++i) diagonal[static_cast<std::size_t>(i)] = number(value[i]);
  }
  for (const double x : diagonal)
    if (!std::isfinite(x) || !(x >= 0)) refuse(name, value, kRule);
  return diagonal;
}

std::optional<double> readTime(const std::string& name, const XmlRpcValue& value) {
  constexpr double kLatest = std::numeric_limits<std::uint32_t>::max();  // of ros::Time
  const double x = number(value);
  if (!(x >= 0) || !(x <= kLatest)) refuse(name, value, "a time >= 0 s that ROS can represent");
  return x;
}

using Reader = std::function<void(const std::string& name, const XmlRpcValue&, NodeOptions&)>;

template <class T>
Reader into(T NodeOptions::*field, T (*read)(const std::string&, const XmlRpcValue&)) {
  return [=](const std::string& name, const XmlRpcValue& value, NodeOptions& options) {
    options.*field = read(name, value);
  };
}

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> table{
      {"body_topics", into(&NodeOptions::body_topics, readBool)},
      {"clock_rate", into(&NodeOptions::clock_rate, readRate)},
      {"command_timeout", into(&NodeOptions::command_timeout, readNotNegative)},
      {"lockstep", into(&NodeOptions::lockstep, readTopics)},
      {"lockstep_period", into(&NodeOptions::lockstep_period, readNotNegative)},
      {"lockstep_timeout", into(&NodeOptions::lockstep_timeout, readNotNegative)},
      {"odometry_covariance", into(&NodeOptions::odometry_covariance, readDiagonal)},
      {"publish_clock", into(&NodeOptions::publish_clock, readBool)},
      {"publish_rate", into(&NodeOptions::publish_rate, readRate)},
      {"real_time_factor", into(&NodeOptions::real_time_factor, readNotNegative)},
      {"reset_time", into(&NodeOptions::reset_time, readBool)},
      {"scene", into(&NodeOptions::scene_text, readSceneText)},
      {"scene_file", into(&NodeOptions::scene_file, readPath)},
      {"start_paused", into(&NodeOptions::start_paused, readBool)},
      {"start_time", into(&NodeOptions::start_time, readTime)},
      {"tf_prefix", into(&NodeOptions::tf_prefix, readPrefix)},
      {"wrench_timeout", into(&NodeOptions::wrench_timeout, readNotNegative)},
  };
  return table;
}

/// diagnostic_updater's own, of which the node makes use.
constexpr char kDiagnosticPeriod[] = "diagnostic_period";

[[noreturn]] void refuseUnknown(const std::string& name, const XmlRpcValue& value) {
  std::vector<std::string> known = parameterNames();
  known.insert(std::lower_bound(known.begin(), known.end(), kDiagnosticPeriod), kDiagnosticPeriod);
  throw ParameterError("parameter ~" + printable(name) + ": unknown, got " + quoted(value) +
                           "; known: " + nameList(known, known.size()),
                       {name});
}

}  // namespace

std::vector<std::string> parameterNames() {
  std::vector<std::string> names;
  for (const auto& [name, reader] : readers()) names.push_back(name);
  return names;
}

NodeOptions toNodeOptions(const XmlRpcValue& parameters) {
  NodeOptions options;
  if (parameters.getType() == XmlRpcValue::TypeStruct) {
    XmlRpcValue copy = parameters;
    for (const auto& [name, value] : copy) {
      if (name == kDiagnosticPeriod) {
        readRate(name, value);
        continue;
      }
      const auto reader = readers().find(name);
      if (reader == readers().end()) refuseUnknown(name, value);
      reader->second(name, value, options);
    }
  }
  if (!options.lockstep.empty() && !parameters.hasMember("lockstep_period"))
    throw ParameterError(
        "parameter ~lockstep: needs ~lockstep_period, > 0 s, which is missing, beside it",
        {"lockstep"});
  if (!options.lockstep.empty() && !(options.lockstep_period > 0))
    refuse("lockstep_period", options.lockstep_period, "> 0 s where ~lockstep names topics");
  if (options.lockstep.empty() && options.lockstep_period > 0)
    refuse("lockstep_period", options.lockstep_period,
           "0 unless ~lockstep names topics: nothing would be waited for");
  if (options.scene_file.empty() == options.scene_text.empty()) {
    const std::string line = "parameters ~scene_file, ~scene: exactly one must be given, got ";
    if (options.scene_file.empty()) throw ParameterError(line + "neither", {});
    throw ParameterError(line + "both", {"scene", "scene_file"});
  }
  return options;
}

void settleClock(NodeOptions& options, bool use_sim_time) {
  options.follow_clock = use_sim_time && !options.publish_clock;
  if (options.publish_clock && !use_sim_time)
    refuse("publish_clock", options.publish_clock,
           "false unless /use_sim_time is true: nobody would follow the clock");
  if (options.reset_time && !options.publish_clock)
    refuse("reset_time", options.reset_time,
           "false unless ~publish_clock is true: stamps would go back while the clock runs on");
  if (options.follow_clock && options.real_time_factor != 1)
    refuse("real_time_factor", options.real_time_factor,
           "1 where ~publish_clock is false and /use_sim_time true: the clock sets the pace");
  if (options.start_time && !options.follow_clock)
    refuse("start_time", *options.start_time,
           "absent unless /use_sim_time is true and ~publish_clock false: no clock is followed");
}

std::string describe(const ParameterError& error, const std::string& node,
                     const std::set<std::string>& given) {
  std::string line = error.what();
  for (const std::string& name : error.parameters)
    if (given.count(name) == 0)
      line += "; it is on the master, maybe from an earlier start: rosparam delete " + node + "/" +
              oneLine(name);
  return line;
}

NodeOptions loadNodeOptions(const std::set<std::string>& given) {
  const std::string& node = ros::this_node::getName();
  XmlRpcValue parameters;
  ros::param::get(node, parameters);
  try {
    NodeOptions options = toNodeOptions(parameters);
    bool use_sim_time = false;
    ros::param::get("/use_sim_time", use_sim_time);
    settleClock(options, use_sim_time);
    return options;
  } catch (const ParameterError& error) {
    throw std::invalid_argument(describe(error, node, given));
  }
}

}  // namespace rigid_body_sim
