#include <ros/console.h>

#include "ros/messages/body_index.hpp"
#include "ros/mouse/menu.hpp"
#include "ros/node/simulation_node.hpp"

/// The menu of the handles: what its choices do.
namespace rigid_body_sim {

void SimulationNode::choose(const HandleTopics::Feedback& feedback) {
  if (const std::string fault = mouse_.faultOf(feedback); !fault.empty())
    return refusals_.add("menu", fault);
  std_srvs::SetBool pausing;
  std_srvs::Trigger resetting;
  switch (static_cast<MenuChoice>(feedback.menu_entry_id)) {
    case MenuChoice::kPause:
    case MenuChoice::kResume:
      pausing.request.data =
          feedback.menu_entry_id == static_cast<std::uint32_t>(MenuChoice::kPause);
      pause(pausing.request, pausing.response);
      return;
    case MenuChoice::kOneStep:
      return queues_.callWithSteps([this] { pauseAndStep(1); });
    case MenuChoice::kTenSteps:
      return queues_.callWithSteps([this] { pauseAndStep(10); });
    case MenuChoice::kSlower:
      return changeRealTimeFactor(slowerFactor(time_.realTimeFactor()));
    case MenuChoice::kFaster:
      return changeRealTimeFactor(fasterFactor(time_.realTimeFactor()));
    case MenuChoice::kReset:
      reset(resetting.request, resetting.response);
      return;
    case MenuChoice::kClearWrenches:
      return inputs_.apply(ClearInput{});
    case MenuChoice::kFollow:
      return followWithCamera(feedback.marker_name);
    case MenuChoice::kStopFollowing:
      return outputs_.follow(std::nullopt);
  }
  refusals_.add("menu", "it has no entry " + std::to_string(feedback.menu_entry_id));
}

/// Pauses where that is needed, and takes steps.
void SimulationNode::pauseAndStep(std::uint32_t steps) {
  std_srvs::SetBool pausing;
  pausing.request.data = true;
  if (!paused_) pause(pausing.request, pausing.response);
  Step stepping;
  stepping.request.steps = steps;
  stepPaused(stepping.request, stepping.response);
  refusals_.check("menu", stepping.response.message);
}

void SimulationNode::changeRealTimeFactor(double factor) {
  const std::string fault = time_.setRealTimeFactor(factor, nextTime());
  refusals_.check("menu", fault);
  if (fault.empty())
    ROS_INFO("real-time factor %g%s", factor, factor == 0 ? ": as fast as possible" : "");
}

void SimulationNode::followWithCamera(const std::string& handle) {
  try {
    outputs_.follow(bodyNamed(handle, simulation_.world().bodies));
  } catch (const std::invalid_argument& unknown) {
    refusals_.add("menu", unknown.what());
  }
}

}  // namespace rigid_body_sim
