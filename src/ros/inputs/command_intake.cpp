#include "ros/inputs/command_intake.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "ros/inputs/message_limits.hpp"
#include "ros/inputs/start_of_input.hpp"
#include "scene/build/build_actuators.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

using sensor_msgs::JointState;

[[noreturn]] void refuse(const std::string& rule) { throw std::invalid_argument(rule); }

void checkLength(const char* field, std::size_t length, std::size_t names) {
  if (length != 0 && length != names)
    refuse(std::string(field) + " must be empty or as long as name, which has " +
           std::to_string(names) + ", got " + std::to_string(length));
}

void checkFields(const JointState& message) {
  if (message.name.empty()) refuse("name must hold at least one actuator, got none");
  if (!message.position.empty()) refuse("position must be empty: no actuator takes a position");
  checkLength("velocity", message.velocity.size(), message.name.size());
  checkLength("effort", message.effort.size(), message.name.size());
  std::set<std::string> names;
  for (const std::string& name : message.name)
    if (!names.insert(name).second)
      refuse("name must hold '" + printable(name) + "' once, got it twice");
}

/// The command at index i: in `own`, while `other` leaves it alone by a zero or by being empty.
double commandAt(std::size_t i, const std::string& name, const char* own_field,
                 const std::vector<double>& own, const char* other_field,
                 const std::vector<double>& other) {
  std::ostringstream fault;
  if (own.empty())
    fault << own_field << " must hold a command for '" << name << "', but is empty: velocity is of "
          << "rotors, effort of thrusters and wheels";
  else if (!std::isfinite(own[i]))
    fault << own_field << " of '" << name << "' must be finite, got " << own[i];
  else if (!other.empty() && !(other[i] == 0))
    fault << other_field << " of '" << name << "' must be 0 or left out, as its command is its "
          << own_field << ", got " << other[i];
  else
    return own[i];
  refuse(fault.str());
}

double commandOf(const Actuator& actuator, const JointState& message, std::size_t i) {
  const std::vector<double>& velocity = message.velocity;
  const std::vector<double>& effort = message.effort;
  return std::holds_alternative<Rotor>(actuator.kind)
             ? commandAt(i, actuator.name, "velocity", velocity, "effort", effort)
             : commandAt(i, actuator.name, "effort", effort, "velocity", velocity);
}

}  // namespace

std::vector<CommandInput> CommandIntake::take(std::size_t body, const JointState& message,
                                              const TimeOrigin& origin, double now) const {
  checkFields(message);
  ActuatorCommand command;
  command.body = body;
  command.start = startOfInput("stamp", message.header.stamp, origin, now, kFarthestCommand);
  if (command_timeout_ > 0) command.end = command.start + command_timeout_;
  std::vector<CommandInput> inputs;
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    command.actuator = actuatorNamed(message.name[i], world_.bodies[body]);
    command.value = commandOf(world_.bodies[body].actuators[command.actuator], message, i);
    inputs.push_back({command});
  }
  return inputs;
}

}  // namespace rigid_body_sim
