#pragma once

#include <string>
#include <vector>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetState.h>
#include <rigid_body_sim/Step.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/frames.hpp>

#include "ros/clock/timekeeper.hpp"
#include "ros/inputs/inputs.hpp"
#include "ros/inputs/static_frames.hpp"
#include "ros/inputs/wrench_doors.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "ros/mouse/mouse.hpp"
#include "ros/node/monitor.hpp"
#include "ros/node/node_options.hpp"
#include "ros/node/refusals.hpp"
#include "ros/outputs/outputs.hpp"

namespace rigid_body_sim {

/// A scene that lives in ROS. One thread, that of run(), owns the state: messages and services are
/// served from a queue of its own, between steps.
class SimulationNode {
 public:
  /// Throws SceneError for a scene that cannot be simulated. Needs ros::init.
  SimulationNode(const NodeOptions& options, const Scene& scene);

  /// Steps and serves until ROS shuts down. Throws SimulationDiverged.
  void run();

 private:
  void serveUntilDue();
  void serve(double seconds);
  double nextTime() const;
  void step();
  void advance();
  void report();
  void track(bool heard);
  void restartClocks();
  void startOver(bool restart_time);
  std::string take(const WrenchRequest& request);
  std::string tryToTake(const WrenchRequest& request);
  WrenchDoors::Cleared clear(const std::string& body, const std::string& slot);

  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool stepPaused(Step::Request& request, Step::Response& response);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool setState(SetState::Request& request, SetState::Response& response);
  bool getState(GetState::Request& request, GetState::Response& response);

  NodeOptions options_;
  Simulation simulation_;
  FrameTable frames_;
  StaticFrames static_frames_;
  IntakeRules rules_;
  std::vector<std::size_t> wrenches_of_scene_;  // by body
  Refusals refusals_;
  bool paused_;
  bool tracked_ = false;    // balance and errors
  std::string divergence_;  // that the simulation waits after, paused; empty: none

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  ros::NodeHandle private_nh_;
  Timekeeper time_;
  Outputs outputs_;
  Inputs inputs_;
  Monitor monitor_;
  Mouse mouse_;
  WrenchDoors doors_;
  ros::Subscriber tf_static_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace rigid_body_sim
