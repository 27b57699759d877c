#include "ros/inputs/input_replay.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "ros/inputs/input_messages.hpp"

namespace rigid_body_sim {
namespace {

std::string mismatch(const Input& input, double time) {
  std::ostringstream text;
  text.precision(17);
  text << "was taken over after step " << input.step << " at " << input.time << " s, which is at "
       << time << " s in this scene: another time_step";
  return text.str();
}

}  // namespace

InputReplay::InputReplay(std::vector<Input> inputs, const std::string& world_frame)
    : inputs_(std::move(inputs)), world_frame_(world_frame) {
  std::uint32_t last_run = 0;
  for (const Input& input : inputs_) last_run = std::max(last_run, input.run);
  inputs_.erase(std::remove_if(inputs_.begin(), inputs_.end(),
                               [&](const Input& input) { return input.run != last_run; }),
                inputs_.end());
  std::sort(inputs_.begin(), inputs_.end(),
            [](const Input& a, const Input& b) { return a.number < b.number; });
  for (std::size_t i = 0; i < inputs_.size(); ++i)
    if (inputs_[i].number != i)
      throw std::invalid_argument("input " + std::to_string(i) +
                                  " of the run is missing: the record must begin before the "
                                  "first input and lose none");
}

bool InputReplay::applyDue(Simulation& simulation) {
  bool moved = false;
  const auto step = static_cast<std::uint64_t>(simulation.steps());
  for (; next_ < inputs_.size() && inputs_[next_].step == step; ++next_) {
    const Input& input = inputs_[next_];
    try {
      if (input.time != simulation.time())
        throw std::invalid_argument(mismatch(input, simulation.time()));
      applyInput(input, world_frame_, simulation);
      moved = moved || (input.kind != Input::WRENCH && input.kind != Input::CLEAR);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("input " + std::to_string(next_) + ": " + error.what());
    }
  }
  return moved;
}

}  // namespace rigid_body_sim
