#include "tools/simulate/input_effects.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/wrenches/delay.hpp"

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
    const double taken = static_cast<double>(timed.step) * time_step;
    end = std::max(end, taken + time_step);  // at the end of the run it would not be taken
    const auto reach = [&end, taken](auto acting) {
      delayTo(taken, acting);
      end = std::max(end, acting.start);
      if (std::isfinite(acting.end)) end = std::max(end, acting.end);
    };
    if (const auto* input = std::get_if<WrenchInput>(&timed.input)) reach(input->wrench);
    if (const auto* input = std::get_if<CommandInput>(&timed.input)) reach(input->command);
  }
  return end;
}

}  // namespace rigid_body_sim
