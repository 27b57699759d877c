#include "ros/inputs/input_messages.hpp"

#include <stdexcept>

#include "ros/messages/body_index.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/node/state_requests.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

std::string nameOf(std::size_t body, const World& world) {
  return body == kWorld ? "" : world.bodies[body].name;
}

std::size_t bodyNamed(const std::string& name, const World& world) {
  const std::size_t i = indexOf(name, world.bodies);
  if (i == world.bodies.size())
    throw std::invalid_argument("unknown body '" + printable(name) + "'");
  return i;
}

std::size_t frameOf(const std::string& name, const World& world) {
  return name.empty() ? kWorld : bodyNamed(name, world);
}

PointWrench wrenchOf(const Input& input, const World& world) {
  PointWrench wrench;
  wrench.body = bodyNamed(input.body, world);
  wrench.axes = frameOf(input.axes, world);
  wrench.force = fromVector3(input.wrench.force);
  wrench.torque = fromVector3(input.wrench.torque);
  wrench.point_frame = frameOf(input.point_frame, world);
  wrench.point = fromPoint(input.point);
  wrench.start = input.start;
  wrench.end = input.end;
  return wrench;
}

void clear(const Input& input, Simulation& simulation) {
  if (!input.body.empty()) {
    const std::size_t body = bodyNamed(input.body, simulation.world());
    if (input.slot.empty())
      simulation.clearWrenches(body);
    else
      simulation.clearWrenches(body, input.slot);
  } else if (input.slot.empty()) {
    simulation.clearWrenches();
  } else {
    simulation.clearWrenches(input.slot);
  }
}

void setState(const Input& input, const std::string& world_frame, Simulation& simulation) {
  SetState::Request request;
  request.body = input.body;
  request.frame = input.frame;
  request.pose = input.pose;
  request.twist = input.twist;
  const RequestedState requested = takeState(request, simulation.world(), world_frame);
  if (!requested.fault.empty()) throw std::invalid_argument(requested.fault);
  simulation.setState(requested.body, requested.state);
}

}  // namespace

Input wrenchInput(const std::string& slot, const PointWrench& wrench, const World& world) {
  Input input;
  input.kind = Input::WRENCH;
  input.body = nameOf(wrench.body, world);
  input.slot = slot;
  input.axes = nameOf(wrench.axes, world);
  input.wrench.force = toVector3(wrench.force);
  input.wrench.torque = toVector3(wrench.torque);
  input.point_frame = nameOf(wrench.point_frame, world);
  input.point = toPoint(wrench.point);
  input.start = wrench.start;
  input.end = wrench.end;
  return input;
}

Input clearInput(const std::string& body, const std::string& slot) {
  Input input;
  input.kind = Input::CLEAR;
  input.body = body;
  input.slot = slot;
  return input;
}

Input setStateInput(const SetState::Request& request) {
  Input input;
  input.kind = Input::SET_STATE;
  input.body = request.body;
  input.frame = request.frame;
  input.pose = request.pose;
  input.twist = request.twist;
  return input;
}

void applyInput(const Input& input, const std::string& world_frame, Simulation& simulation) {
  switch (input.kind) {
    case Input::WRENCH:
      simulation.applyWrench(input.slot, wrenchOf(input, simulation.world()));
      break;
    case Input::CLEAR:
      clear(input, simulation);
      break;
    case Input::SET_STATE:
      setState(input, world_frame, simulation);
      break;
    case Input::RESET:
      simulation.reset(false);
      break;
    case Input::RESTART:
      simulation.reset(true);
      break;
    default:
      throw std::invalid_argument("unknown kind of input " + std::to_string(input.kind));
  }
}

}  // namespace rigid_body_sim
