#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>

#include "ros/mouse/handle_topics.hpp"
#include "ros/mouse/mouse_holds.hpp"
#include "ros/node/refusals.hpp"

namespace rigid_body_sim {

/// Bodies pushed with the mouse in a viewer: handles out, pulls on the bodies in.
class Mouse {
 public:
  Mouse(const ros::NodeHandle& private_nh, const Scene& scene, const Simulation& simulation,
        Inputs& inputs, double wrench_timeout, Refusals& refusals);

  /// Applies the pulls for the step to come.
  void pull();

  /// The wrenches of a body have been cleared, empty: of all bodies.
  void letGo(const std::string& body) { holds_.letGo(body); }

  void keepAlive(HandleTopics::Clock::time_point now) { topics_.keepAlive(now); }

 private:
  void take(const HandleTopics::Feedback& feedback);

  MouseHolds holds_;
  Refusals& refusals_;
  HandleTopics topics_;
};

}  // namespace rigid_body_sim
