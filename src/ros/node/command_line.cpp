#include "ros/node/command_line.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <ros/exceptions.h>
#include <ros/init.h>
#include <ros/network.h>

#include "ros/options/node_options.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

const std::string kAssigns = ":=";

/// An address that roscpp would end the program for.
std::string faultOfMaster(int argc, char** argv) {
  const bool given = std::any_of(argv, argv + argc, [](const std::string& argument) {
    return argument.rfind("__master:=", 0) == 0;
  });
  const char* const uri = std::getenv("ROS_MASTER_URI");
  std::string host;
  std::uint32_t port = 0;
  if (given || (uri && ros::network::splitURI(uri, host, port))) return "";
  return std::string("ROS_MASTER_URI must be like http://localhost:11311, got '") +
         printable(uri ? uri : "") + "'";
}

std::string wouldRename(const std::string& argument, const std::string& parameter,
                        const std::string& value) {
  return "'" + printable(argument) + "' would rename a topic; a parameter begins with _: _" +
         parameter + kAssigns + printable(value);
}

}  // namespace

bool initRos(int& argc, char** argv, const std::string& name, unsigned init_options) {
  std::string fault = faultOfMaster(argc, argv);
  try {
    if (fault.empty()) ros::init(argc, argv, name, init_options);
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
