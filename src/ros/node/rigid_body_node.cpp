#include <csignal>
#include <cstdio>
#include <exception>
#include <set>
#include <string>

#include <ros/ros.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "programs/package_directory.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/usage.hpp"
#include "ros/node/command_line.hpp"
#include "ros/node/shutdown_watch.hpp"
#include "ros/node/simulation_node.hpp"
#include "scene/message_text.hpp"

using namespace rigid_body_sim;

namespace {

const char* const kHelp =
    R"(usage: rosrun rigid_body_sim rigid_body_node _scene_file:=FILE [_PARAMETER:=VALUE ...]
Simulates a scene in ROS time: takes wrenches and commands from topics and services, publishes odometry
and tf.

  _scene_file:=FILE        the scene; or _scene:=TEXT, its YAML text
  _publish_rate:=HZ        of states, per second of simulation time; default 100
  _real_time_factor:=X     simulated over wall time, 0: as fast as possible; default 1
  _wrench_timeout:=S       how long a wrench without a duration is held, 0: until replaced;
                           default 0.5
  _command_timeout:=S      how long a command to an actuator is held, 0: until replaced; default 0.5
  _lockstep:=TOPIC         wait for a message on it at every multiple of the period; or a list of
                           topics
  _lockstep_period:=S      in simulation time, a multiple of the time step; needed with lockstep
  _lockstep_timeout:=S     in wall time, after which the node ends; default 0: never
  _publish_clock:=BOOL     start at 0 and send /clock; needs /use_sim_time; default false
  _clock_rate:=HZ          of /clock, per second of simulation time; default 100
  _start_time:=S           time on the /clock that the node follows at which the run starts; default:
                           the first that is received
  _start_paused:=BOOL      default false
  _body_topics:=BOOL       false: no topics of single bodies, which saves starting time with
                           thousands of them; default true
  _tf_prefix:=NAME         before the tf frames of bodies and points: NAME/<body>; default none
  _odometry_covariance:=X  diagonal of both covariances in odometry, or a list of six numbers;
                           default 0: exact
  _reset_time:=BOOL        ~reset sets time back, too; needs publish_clock; default false
  _diagnostic_period:=S    of diagnostic_updater, in ROS time; default 1
  --help                   this text

Needs a ROS master. Topics and services: doc/node.md of the package.
Exit status: 0 shut down, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";

// roscpp turns only SIGINT into a shutdown
void onSignal(int) { ros::requestShutdown(); }

Scene readScene(const NodeOptions& options) {
  return options.scene_file.empty()
             ? parseScene(options.scene_text, "parameter ~scene", packageDirectory)
             : loadScene(options.scene_file, packageDirectory);
}

int refuseUsage(const std::string& fault) {
  std::fprintf(stderr, "rigid_body_node: %s (rigid_body_node --help)\n", fault.c_str());
  return kWrongUsage;
}

/// As ROS_FATAL, which writes nothing once the node is being stopped.
void logFatal(const char* text) {
  if (ros::ok() && !ros::isShuttingDown())
    ROS_FATAL("%s", text);
  else
    std::fprintf(stderr, "[FATAL]: %s\n", text);
}

int run(const NodeOptions& options, const Scene& scene) {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  const ros::NodeHandle keeps_ros_started;  // and its log, beyond the node itself
  if (!ros::ok()) return kDone;
  const ShutdownWatch ends_a_long_step;
  try {
    SimulationNode node(options, scene);
    // not before: the line on a scene that is at fault stands alone
    for (const std::string& notice : scene.notices) ROS_WARN("%s", notice.c_str());
    node.run();
    return kDone;
  } catch (const SimulationDiverged& error) {
    logFatal(error.what());
    return kDiverged;
  } catch (const std::exception&) {
    if (!ros::ok()) return kDone;  // a shutdown ends what waits, too
    throw;
  }
}

}  // namespace

int main(int argc, char** argv) {
  reserveStandardStreams();
  failBeyondFileSize();
  if (asksForHelp(argc, argv)) return printHelp("rigid_body_node", kHelp);
  const std::string fault = missingUnderscore(argc, argv);
  if (!fault.empty()) return refuseUsage(fault);
  const std::set<std::string> given = givenParameters(argc, argv);
  if (!initRos(argc, argv, "rigid_body_node", ros::init_options::NoSigintHandler))
    return kWrongUsage;
  if (argc > 1)  // roscpp has taken what is for it
    return refuseUsage("unknown argument '" + printable(argv[1]) +
                       "'; a scene is given as _scene_file:=FILE");
  try {
    // Until the scene is read nothing is registered with the master, and signals end the program: a
    // file that is a pipe may never be written.
    const NodeOptions options = loadNodeOptions(given);
    return run(options, readScene(options));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rigid_body_node: %s\n", error.what());
    return kBadInput;
  }
}
