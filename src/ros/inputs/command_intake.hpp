#pragma once

#include <string>
#include <vector>

#include <sensor_msgs/JointState.h>

#include <rigid_body_sim/dynamics/input.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// Turns the messages on <body>/command into inputs of the core. The rules of that topic are
/// checked here and once: a message is taken whole or not at all.
class CommandIntake {
 public:
  /// command_timeout [s]: that long after its start a command of a message ends; 0: never. The
  /// world, that of the scene, is referred to, not copied.
  CommandIntake(const World& world, double command_timeout)
      : world_(world), command_timeout_(command_timeout) {}

  /// A message that arrives at simulation time `now` [s], one input for each name. Its commands
  /// take effect at its stamp; now where that is zero or past.
  ///
  /// Throws std::invalid_argument, one line, for a message without names, a name that is unknown or
  /// stands twice, `velocity` or `effort` of another length than `name`, a command that is missing,
  /// not finite, or in the field of another kind of actuator, for positions, and for a stamp more
  /// than an hour ahead.
  std::vector<CommandInput> take(std::size_t body, const sensor_msgs::JointState& message,
                                 const TimeOrigin& origin, double now) const;

 private:
  const World& world_;
  double command_timeout_;
};

}  // namespace rigid_body_sim
