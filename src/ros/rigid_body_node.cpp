#include <csignal>
#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "simulation_node.hpp"
#include "tools/package_directory.hpp"

using namespace rigid_body_sim;

namespace {

enum ExitCode { kDone = 0, kBadInput = 1, kDiverged = 3 };

// roscpp turns only SIGINT into a shutdown
void onSignal(int) { ros::requestShutdown(); }

Scene readScene(const NodeOptions& options) {
  return options.scene_file.empty()
             ? parseScene(options.scene_text, "parameter ~scene", packageDirectory)
             : loadScene(options.scene_file, packageDirectory);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "rigid_body_node", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  const ros::NodeHandle keeps_ros_started;  // and its log, beyond the node itself
  if (!ros::ok()) return kDone;
  try {
    const NodeOptions options = loadNodeOptions();
    const Scene scene = readScene(options);
    SimulationNode node(options, scene);
    // not before: the line on a scene that is at fault stands alone
    for (const std::string& notice : scene.notices) ROS_WARN("%s", notice.c_str());
    node.run();
    return kDone;
  } catch (const SimulationDiverged& error) {
    ROS_FATAL("%s", error.what());
    return kDiverged;
  } catch (const std::exception& error) {
    // a shutdown on the way here leaves parameters unread
    if (!ros::ok()) return kDone;
    std::fprintf(stderr, "rigid_body_node: %s\n", error.what());
    return kBadInput;
  }
}
