#include "ros/inputs/input_messages.hpp"

#include <stdexcept>

#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "ros/inputs/mass_service.hpp"
#include "ros/inputs/state_requests.hpp"
#include "ros/messages/body_index.hpp"
#include "ros/messages/conversions.hpp"
#include "scene/build/build_actuators.hpp"

namespace rigid_body_sim {
namespace {

/// Empty for the world; an index that is of no body stands for the body acted on.
std::string frameName(std::size_t index, std::size_t acted_on, const World& world) {
  if (index == kWorld) return "";
  return world.bodies[index < world.bodies.size() ? index : acted_on].name;
}

std::size_t frameOf(const std::string& name, const World& world) {
  return name.empty() ? kWorld : bodyNamed(name, world.bodies);
}

/// In the place of a frame of `point`: that of the body acted on, which goes along when mass
/// properties are set. No name of a body has spaces.
const char* const kCenterOfMass = "centre of mass";

Input messageOf(const WrenchInput& input, const World& world, const std::string&) {
  const PointWrench& wrench = input.wrench;
  Input message;
  message.kind = Input::WRENCH;
  message.body = world.bodies[wrench.body].name;
  message.slot = input.slot;
  message.axes = frameName(wrench.axes, wrench.body, world);
  message.wrench.force = toVector3(wrench.force);
  message.wrench.torque = toVector3(wrench.torque);
  message.point_frame =
      wrench.at_center ? kCenterOfMass : frameName(wrench.point_frame, wrench.body, world);
  message.point = toPoint(wrench.point);
  message.start = wrench.start;
  message.end = wrench.end;
  return message;
}

Input messageOf(const ClearInput& input, const World& world, const std::string&) {
  Input message;
  message.kind = Input::CLEAR;
  if (input.body != ClearInput::kEveryBody) message.body = world.bodies[input.body].name;
  message.slot = input.slot;
  return message;
}

Input messageOf(const StateInput& input, const World& world, const std::string& world_frame) {
  Input message;
  message.kind = Input::SET_STATE;
  message.body = world.bodies[input.body].name;
  message.frame = world_frame;
  message.pose = toPose(input.motion);
  message.twist.linear = toVector3(input.motion.v_W);
  message.twist.angular = toVector3(input.motion.w_W);
  return message;
}

Input messageOf(const ResetInput& input, const World&, const std::string&) {
  Input message;
  message.kind = input.restart_time ? Input::RESTART : Input::RESET;
  return message;
}

Input messageOf(const CommandInput& input, const World& world, const std::string&) {
  const ActuatorCommand& command = input.command;
  const Body& body = world.bodies[command.body];
  Input message;
  message.kind = Input::COMMAND;
  message.body = body.name;
  message.actuator = body.actuators[command.actuator].name;
  message.value = command.value;
  message.start = command.start;
  message.end = command.end;
  return message;
}

Input messageOf(const LoadInput& input, const World& world, const std::string&) {
  Input message;
  message.kind = Input::LOAD;
  message.state = stateText(world, input.state);
  return message;
}

Input messageOf(const WindInput& input, const World&, const std::string& world_frame) {
  Input message;
  message.kind = Input::WIND;
  message.frame = world_frame;
  message.twist.linear = toVector3(input.velocity_W);
  return message;
}

Input messageOf(const MassInput& input, const World& world, const std::string&) {
  Input message;
  message.kind = Input::MASS;
  message.body = world.bodies[input.body].name;
  message.inertia = toInertia(input.properties_B);
  return message;
}

Input messageOf(const PresenceInput& input, const World& world, const std::string& world_frame) {
  Input message;
  message.kind = Input::LEAVE;
  if (input.motion) {
    message = messageOf(StateInput{input.body, *input.motion}, world, world_frame);
    message.kind = Input::ENTER;
  }
  message.body = world.bodies[input.body].name;
  return message;
}

WrenchInput wrenchOf(const Input& message, const World& world) {
  PointWrench wrench;
  wrench.body = bodyNamed(message.body, world.bodies);
  wrench.axes = frameOf(message.axes, world);
  wrench.force = fromVector3(message.wrench.force);
  wrench.torque = fromVector3(message.wrench.torque);
  wrench.at_center = message.point_frame == kCenterOfMass;
  wrench.point_frame = wrench.at_center ? wrench.body : frameOf(message.point_frame, world);
  wrench.point = fromPoint(message.point);
  wrench.start = message.start;
  wrench.end = message.end;
  return {message.slot, wrench};
}

ClearInput clearOf(const Input& message, const World& world) {
  ClearInput input;
  if (!message.body.empty()) input.body = bodyNamed(message.body, world.bodies);
  input.slot = message.slot;
  return input;
}

StateInput stateOf(const Input& message, const World& world, const std::string& world_frame) {
  SetState::Request request;
  request.body = message.body;
  request.frame = message.frame;
  request.pose = message.pose;
  request.twist = message.twist;
  return takeState(request, world, world_frame);
}

MassInput massOf(const Input& message, const World& world) {
  SetMassProperties::Request request;
  request.body = message.body;
  request.inertia = message.inertia;
  return takeMassProperties(request, world);
}

CommandInput commandOf(const Input& message, const World& world) {
  ActuatorCommand command;
  command.body = bodyNamed(message.body, world.bodies);
  command.actuator = actuatorNamed(message.actuator, world.bodies[command.body]);
  command.value = message.value;
  command.start = message.start;
  command.end = message.end;
  return {command};
}

LoadInput loadOf(const Input& message, const World& world) {
  try {
    return {parseState(message.state, "state", world)};
  } catch (const SceneError& fault) {
    throw std::invalid_argument(fault.what());
  }
}

}  // namespace

Input toMessage(const SimulationInput& input, const World& world, const std::string& world_frame) {
  return std::visit([&](const auto& kind) { return messageOf(kind, world, world_frame); }, input);
}

SimulationInput toInput(const Input& message, const World& world, const std::string& world_frame) {
  switch (message.kind) {
    case Input::WRENCH:
      return wrenchOf(message, world);
    case Input::CLEAR:
      return clearOf(message, world);
    case Input::SET_STATE:
      return stateOf(message, world, world_frame);
    case Input::RESET:
      return ResetInput{false};
    case Input::RESTART:
      return ResetInput{true};
    case Input::COMMAND:
      return commandOf(message, world);
    case Input::LOAD:
      return loadOf(message, world);
    case Input::WIND:
      return WindInput{fromVector3(message.twist.linear)};
    case Input::MASS:
      return massOf(message, world);
    case Input::ENTER: {
      const StateInput state = stateOf(message, world, world_frame);
      return PresenceInput{state.body, state.motion};
    }
    case Input::LEAVE:
      return PresenceInput{bodyNamed(message.body, world.bodies), std::nullopt};
    default:
      throw std::invalid_argument("unknown kind of input " + std::to_string(message.kind));
  }
}

}  // namespace rigid_body_sim
