#include "ros/mouse/mouse.hpp"

#include "ros/mouse/handles.hpp"

namespace rigid_body_sim {

Mouse::Mouse(const ros::NodeHandle& private_nh, const Scene& scene, const Simulation& simulation,
             Inputs& inputs, double wrench_timeout, Refusals& refusals)
    : holds_(simulation, inputs, wrench_timeout),
      refusals_(refusals),
      topics_(private_nh, toHandles(scene, simulation.world()),
              [this](const HandleTopics::Feedback& feedback) { take(feedback); }) {}

void Mouse::pull() {
  const std::string fault = holds_.pull();
  if (!fault.empty()) refusals_.add("mouse feedback", fault);
}

void Mouse::take(const HandleTopics::Feedback& feedback) {
  const std::string fault = holds_.take(feedback);
  if (!fault.empty()) refusals_.add("mouse feedback", fault);
  // even if the body was let go before: the viewer has dragged its handle away
  if (feedback.event_type == HandleTopics::Feedback::MOUSE_UP)
    topics_.putBack(feedback.marker_name);
}

}  // namespace rigid_body_sim
