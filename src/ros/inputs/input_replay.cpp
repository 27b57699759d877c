#include "ros/inputs/input_replay.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "math/shortest.hpp"
#include "ros/inputs/input_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Keeps the messages of the last run, in the order in which they were applied.
void keepLastRun(std::vector<Input>& messages) {
  std::uint32_t last_run = 0;
  for (const Input& message : messages) last_run = std::max(last_run, message.run);
  messages.erase(std::remove_if(messages.begin(), messages.end(),
                                [&](const Input& message) { return message.run != last_run; }),
                 messages.end());
  std::sort(messages.begin(), messages.end(),
            [](const Input& a, const Input& b) { return a.number < b.number; });
}

void requireComplete(const std::vector<Input>& messages) {
  for (std::size_t i = 0; i < messages.size(); ++i)
    if (messages[i].number != i)
      throw std::invalid_argument("input " + std::to_string(i) +
                                  " of the run is missing: the record must begin before the "
                                  "first input and lose none");
}

/// From a state that was loaded on, steps are counted as in the run that it is from.
std::uint64_t stepOf(const Input& message) {
  return message.kind == Input::LOAD ? 0 : message.step;
}

void requireFirst(std::size_t number, const Input& message) {
  if (message.kind == Input::LOAD && number > 0)
    throw std::invalid_argument("a state is loaded at the start of a run only");
}

void requireAfter(std::uint64_t before, const Input& message) {
  if (message.step < before)
    throw std::invalid_argument("was taken over after step " + std::to_string(message.step) +
                                ", the one before after step " + std::to_string(before) +
                                ": the record mixes runs or has been changed");
}

void requireStepOf(const World& world, const Input& message) {
  const double time = static_cast<double>(message.step) * world.solver.time_step;
  if (message.time == time) return;
  std::ostringstream text;
  text << "was taken over after step " << message.step << " at " << shortest(message.time)
       << " s, which is at " << shortest(time) << " s in this scene: another time_step";
  throw std::invalid_argument(text.str());
}

/// Calls a function for one of the inputs; what it throws begins with the number of that input.
template <class Function>
auto naming(std::size_t number, const Function& function) {
  try {
    return function();
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument("input " + std::to_string(number) + ": " + fault.what());
  }
}

bool movesBodies(const SimulationInput& input) {
  return std::holds_alternative<StateInput>(input) ||
         std::holds_alternative<PresenceInput>(input) ||
         std::holds_alternative<ResetInput>(input) || std::holds_alternative<LoadInput>(input);
}

}  // namespace

std::vector<TimedInput> lastRun(std::vector<Input> messages, const World& world,
                                const std::string& world_frame) {
  keepLastRun(messages);
  requireComplete(messages);
  std::vector<TimedInput> inputs;
  inputs.reserve(messages.size());
  std::uint64_t before = 0;
  for (const Input& message : messages) {
    inputs.push_back(naming(inputs.size(), [&] {
      requireFirst(inputs.size(), message);
      requireAfter(before, message);
      requireStepOf(world, message);
      before = message.step;
      return TimedInput{stepOf(message), toInput(message, world, world_frame)};
    }));
  }
  return inputs;
}

bool InputReplay::applyDue(Simulation& simulation) {
  bool moved = false;
  const auto isDue = [&simulation](const TimedInput& input) {  // a state loaded is of another step
    return input.step == static_cast<std::uint64_t>(simulation.steps());
  };
  for (; next_ < inputs_.size() && isDue(inputs_[next_]); ++next_) {
    const SimulationInput& input = inputs_[next_].input;
    naming(next_, [&] { simulation.apply(input); });
    moved = moved || movesBodies(input);
  }
  return moved;
}

}  // namespace rigid_body_sim
