#include <chrono>

#include <ros/console.h>

#include "ros/node/simulation_node.hpp"

/// The services ~pause, ~step, ~set_real_time_factor and ~reset.
namespace rigid_body_sim {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// While ~step takes many steps, other callbacks are served that often.
constexpr std::chrono::milliseconds kServicePeriod(50);

}  // namespace

bool SimulationNode::pause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  if (paused_ && !request.data) {
    time_.restart(outputs_.shownTime());
    lockstep_.restartPatience(SteadyClock::now());
    outputs_.publishDue();
  }
  // a paused simulation is at a step, unless the clock that it follows has not come so far
  if (!paused_ && request.data && within_step_ && !time_.isAhead(nextTime())) advance();
  paused_ = request.data;
  outputs_.setStanding(paused_ || lockstep_.isWaiting());
  response.success = true;
  response.message = paused_ ? "paused" : "running";
  if (paused_ && is_stepping_)
    response.message += ", but the ~step under way goes on: false ends it";
  return true;
}

bool SimulationNode::stepPaused(Step::Request& request, Step::Response& response) {
  std::uint32_t taken = 0;
  is_stepping_ = true;
  SteadyClock::time_point serve_next = SteadyClock::now() + kServicePeriod;
  if (!paused_) response.message = stepFault();
  try {
    while (response.message.empty() && taken < request.steps) {
      response.message = lateMessages();
      if (response.message.empty())
        response.message = paused_ ? stepFault() : "not paused any more: resuming has ended it";
      if (!response.message.empty()) break;
      advance();
      ++taken;
      if (SteadyClock::now() < serve_next) continue;
      serve(0);
      serve_next = SteadyClock::now() + kServicePeriod;
    }
    if (taken > 0) outputs_.publishNow();
  } catch (const SimulationDiverged& error) {
    // paused: the last finite state waits for a reset
    ROS_FATAL("%s", error.what());
    response.message = error.what();
  } catch (const BeyondRosTime& error) {
    response.message = error.what();
  }
  is_stepping_ = false;
  response.success = response.message.empty();
  if (!response.success && taken > 0)
    response.message +=
        "; " + std::to_string(taken) + " of " + std::to_string(request.steps) + " steps were taken";
  response.stamp = inputs_.stamp();
  return true;
}

/// Waits, in lockstep, for the messages without which the next step must not be taken. Returns what
/// did not come while a caller may be expected to wait; empty where all has come.
std::string SimulationNode::lateMessages() {
  const SteadyClock::time_point patience = SteadyClock::now() + lockstep_.patience();
  while (lockstep_.isWaiting() && stepFault().empty()) {
    if (!lockstep_.fault().empty()) return lockstep_.fault();
    if (SteadyClock::now() > patience) return "lockstep: " + lockstep_.missing() + " did not come";
    serve(lockstep_.hasAll() ? 0 : Timekeeper::kLongestWait);
    takeInStep();
  }
  return "";
}

/// Why no step may be taken by ~step now; empty if one may.
std::string SimulationNode::stepFault() const {
  if (!ros::ok()) return "the node shuts down";
  if (!paused_) return "not paused: ~step advances a paused simulation only";
  if (time_.isAhead(nextTime())) return "the next step would pass the clock that this node follows";
  return "";
}

bool SimulationNode::setRealTimeFactor(SetRealTimeFactor::Request& request,
                                       SetRealTimeFactor::Response& response) {
  response.message = time_.setRealTimeFactor(request.factor, nextTime());
  response.success = response.message.empty();
  return true;
}

bool SimulationNode::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  inputs_.apply(ResetInput{reset_time_});
  response.success = true;
  response.message =
      reset_time_ ? "initial states, time at the start" : "initial states, time runs on";
  return true;
}

}  // namespace rigid_body_sim
