#include "ros/node/command_line.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include <ros/exceptions.h>
#include <ros/init.h>
#include <ros/network.h>

#include "ros/options/node_options.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

const std::string kAssigns = ":=";

/// What the last of the arguments NAME:=VALUE says, which counts for roscpp; none where there is
/// none.
std::optional<std::string> remapped(int argc, char** argv, const std::string& name) {
  std::optional<std::string> value;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind(name + kAssigns, 0) == 0)
      value = argument.substr(name.size() + kAssigns.size());
  }
  return value;
}

bool isAddress(const std::string& uri) {
  constexpr std::uint32_t kLastPort = 65535;
  std::string host;
  std::uint32_t port = 0;
  return uri.rfind("http://", 0) == 0 && ros::network::splitURI(uri, host, port) && !host.empty() &&
         port > 0 && port <= kLastPort;
}

/// An address that roscpp would end the program for, or wait at for ever.
std::string faultOfMaster(int argc, char** argv) {
  std::string source = "__master", uri = remapped(argc, argv, source).value_or("");
  if (uri.empty()) {
    source = "ROS_MASTER_URI";
    const char* const set = std::getenv(source.c_str());
    uri = set ? set : "";
  }
  if (isAddress(uri)) return "";
  return source + " must be like http://localhost:11311, got '" + printable(uri) + "'";
}

/// A name that roscpp would take for that of the root, whose parameters are not the node's.
std::string faultOfName(int argc, char** argv) {
  return remapped(argc, argv, "__name") == "" ? "__name must be followed by a name, got ''" : "";
}

std::string wouldRename(const std::string& argument, const std::string& parameter,
                        const std::string& value) {
  return "'" + printable(argument) + "' would rename a topic; a parameter begins with _: _" +
         parameter + kAssigns + printable(value);
}

}  // namespace

bool initRos(int& argc, char** argv, const std::string& name, unsigned init_options) {
  std::string fault = faultOfMaster(argc, argv);
  if (fault.empty()) fault = faultOfName(argc, argv);
  try {
    if (fault.empty()) ros::init(argc, argv, name, init_options);
  } catch (const ros::InvalidPortException& error) {
    fault = oneLine(error.what());
  } catch (const ros::Exception& error) {
    fault = "a name given by := is not one of ROS: " + oneLine(error.what());
  }
  if (!fault.empty()) std::fprintf(stderr, "%s: %s\n", name.c_str(), fault.c_str());
  return fault.empty();
}

std::set<std::string> givenParameters(int argc, char** argv) {
  std::set<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t end = argument.find(kAssigns);
    if (end != std::string::npos && argument[0] == '_') names.insert(argument.substr(1, end - 1));
  }
  return names;
}

std::string missingUnderscore(int argc, char** argv) {
  const std::vector<std::string> known = parameterNames();
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t end = argument.find(kAssigns);
    if (end == std::string::npos) continue;
    const std::size_t begin = argument[0] == '~' ? 1 : 0;
    const std::string name = argument.substr(begin, end - begin);
    if (std::find(known.begin(), known.end(), name) == known.end()) continue;
    const std::string value = argument.substr(end + kAssigns.size());
    const bool is_path = name == "scene" && value.find(": ") == std::string::npos;
    return wouldRename(argument, is_path ? "scene_file" : name, value);
  }
  return "";
}

}  // namespace rigid_body_sim
