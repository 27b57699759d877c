#include <csignal>
#include <cstdio>
#include <exception>

#include <ros/ros.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "programs/package_directory.hpp"
#include "programs/usage.hpp"
#include "ros/node/simulation_node.hpp"
#include "scene/message_text.hpp"

using namespace rigid_body_sim;

namespace {

const char* const kHelp =
    R"(usage: rosrun rigid_body_sim rigid_body_node _scene_file:=FILE [_PARAMETER:=VALUE ...]
Simulates a scene in ROS time: takes wrenches from topics and services, publishes odometry and tf.

  _scene_file:=FILE        the scene; or _scene:=TEXT, its YAML text
  _publish_rate:=HZ        of states, per second of simulation time; default 100
  _real_time_factor:=X     simulated over wall time, 0: as fast as possible; default 1
  _wrench_timeout:=S       how long a wrench without a duration is held, 0: until replaced;
                           default 0.5
  _publish_clock:=BOOL     start at 0 and send /clock; needs /use_sim_time; default false
  _clock_rate:=HZ          of /clock, per second of simulation time; default 100
  _start_time:=S           where on a /clock that is followed the run starts; default: where it is
                           first heard
  _start_paused:=BOOL      default false
  _reset_time:=BOOL        ~reset sets time back, too; needs publish_clock; default false
  --help                   this text

Needs a ROS master. Topics and services: README.md of the package.
Exit status: 0 shut down, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";

// roscpp turns only SIGINT into a shutdown
void onSignal(int) { ros::requestShutdown(); }

Scene readScene(const NodeOptions& options) {
  return options.scene_file.empty()
             ? parseScene(options.scene_text, "parameter ~scene", packageDirectory)
             : loadScene(options.scene_file, packageDirectory);
}

}  // namespace

int main(int argc, char** argv) {
  if (asksForHelp(argc, argv)) return std::fputs(kHelp, stdout) < 0 ? kBadInput : kDone;
  ros::init(argc, argv, "rigid_body_node", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  const ros::NodeHandle keeps_ros_started;  // and its log, beyond the node itself
  if (!ros::ok()) return kDone;
  if (argc > 1) {  // roscpp has taken what is for it
    std::fprintf(stderr, "rigid_body_node: unknown argument '%s'; a scene is given as %s\n",
                 printable(argv[1]).c_str(), "_scene_file:=FILE (rigid_body_node --help)");
    return kWrongUsage;
  }
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
