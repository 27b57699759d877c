#pragma once

#include <cstddef>
#include <vector>

#include "ros/inputs/input_replay.hpp"

namespace rigid_body_sim {

/// What recorded inputs did to a body, beside the laws and wrenches of the scene.
struct InputEffects {
  bool wrench = false;    ///< a wrench was applied
  bool moved = false;     ///< its state was set, or the run reset
  bool mass = false;      ///< its mass properties were set
  bool presence = false;  ///< it came in or left
};

/// Of each of so many bodies, by the first `applied` of the inputs.
std::vector<InputEffects> effectsOf(const std::vector<TimedInput>& inputs, std::size_t applied,
                                    std::size_t bodies);

/// [s] When all inputs have been applied and their wrenches and commands have ended, as far as they
/// do.
double endOfEffects(const std::vector<TimedInput>& inputs, double time_step);

}  // namespace rigid_body_sim
