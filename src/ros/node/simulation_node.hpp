#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include <ros/console.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <rigid_body_sim/SetRealTimeFactor.h>
#include <rigid_body_sim/Step.h>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "programs/step_watch.hpp"
#include "ros/clock/timekeeper.hpp"
#include "ros/inputs/input_interfaces.hpp"
#include "ros/inputs/inputs.hpp"
#include "ros/inputs/lockstep.hpp"
#include "ros/inputs/refusals.hpp"
#include "ros/mouse/handle_topics.hpp"
#include "ros/mouse/mouse.hpp"
#include "ros/node/monitor.hpp"
#include "ros/node/node_queues.hpp"
#include "ros/options/node_options.hpp"
#include "ros/outputs/outputs.hpp"

namespace rigid_body_sim {

/// A scene simulated in ROS time. One thread, that of run(), owns the state: messages and services
/// are served from queues of the node's own, between steps.
class SimulationNode {
 public:
  /// Throws SceneError for a scene that cannot be simulated. Needs ros::init.
  SimulationNode(const NodeOptions& options, const Scene& scene);

  /// Steps and serves until ROS shuts down. Throws SimulationDiverged.
  void run();

 private:
  void serveUntilDue();
  bool maySleepOverSteps();
  void sleepOverSteps();
  void serve(double seconds);
  void waitInStep();
  void serveInStep();
  void takeInStep();
  double nextTime() const;
  void repeat();
  void goOn();
  void publishWithinStep(const std::function<void()>& publish);
  void advance();
  void endStep();
  void leaveStep();
  void prepareForInput();
  void reportingDivergence(const std::function<void()>& action);
  void report();
  void restartClocks();
  void follow(const SimulationInput& input);
  void beginAnew(bool loads);
  void followBodies();

  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool stepPaused(Step::Request& request, Step::Response& response);
  bool setRealTimeFactor(SetRealTimeFactor::Request& request,
                         SetRealTimeFactor::Response& response);
  std::string stepFault() const;
  std::string lateMessages();
  void choose(const HandleTopics::Feedback& feedback);
  void pauseAndStep(std::uint32_t steps);
  void changeRealTimeFactor(double factor);
  void followWithCamera(const std::string& handle);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  StepWatch watch_{[](const std::string& text) { ROS_WARN("%s", text.c_str()); }};
  const bool reset_time_;
  Simulation simulation_;
  std::optional<Simulation> rest_of_step_;       // shown while the simulation is at the step's end
  std::optional<std::size_t> followed_changes_;  // of the world; see followBodies
  bool pulled_ = false;                          // by the mouse, for the next step
  bool within_step_ = false;                     // a state within the next step has been shown
  int slept_over_ = 1;                           // steps, at most; see sleepOverSteps
  std::chrono::steady_clock::time_point next_repeat_;  // while time stands
  Refusals refusals_;
  bool paused_;
  bool is_stepping_ = false;  // a ~step is under way
  std::string divergence_;    // after which the simulation waits, paused, for a reset; empty: none

  NodeQueues queues_;
  Timekeeper time_;
  Outputs outputs_;
  Inputs inputs_;
  Monitor monitor_;
  Mouse mouse_;
  HandleTopics handles_;
  Lockstep lockstep_;
  InputInterfaces interfaces_;
  ros::ServiceServer pause_, step_, reset_, real_time_factor_;
};

}  // namespace rigid_body_sim
