#include "tools/simulate/input_effects.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {

std::vector<InputEffects> effectsOf(const std::vector<TimedInput>& inputs, std::size_t applied,
                                    std::size_t bodies) {
  std::vector<InputEffects> effects(bodies);
  for (std::size_t i = 0; i < applied; ++i) {
    const SimulationInput& input = inputs[i].input;
    if (const auto* wrench = std::get_if<WrenchInput>(&input))
      effects[wrench->wrench.body].wrench = true;
    else if (const auto* state = std::get_if<StateInput>(&input))
      effects[state->body].moved = true;
    else if (const auto* mass = std::get_if<MassInput>(&input))
      effects[mass->body].mass = true;
    else if (const auto* presence = std::get_if<PresenceInput>(&input))
      effects[presence->body].presence = true;
    else if (std::holds_alternative<ResetInput>(input))
      for (InputEffects& each : effects) each.moved = true;
  }
  return effects;
}

double endOfEffects(const std::vector<TimedInput>& inputs, double time_step) {
  double end = 0;
  for (const TimedInput& timed : inputs) {
    end = std::max(end, static_cast<double>(timed.step) * time_step);
    const auto* wrench = std::get_if<WrenchInput>(&timed.input);
    if (wrench && std::isfinite(wrench->wrench.end)) end = std::max(end, wrench->wrench.end);
    const auto* input = std::get_if<CommandInput>(&timed.input);
    if (!input) continue;
    end = std::max(end, input->command.start);
    if (std::isfinite(input->command.end)) end = std::max(end, input->command.end);
  }
  return end;
}

}  // namespace rigid_body_sim
