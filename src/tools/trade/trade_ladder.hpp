#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/trade/trade_setting.hpp"

namespace rigid_body_sim {

/// The integrators of the catalogue that support the scene, and auto.
std::vector<std::string> integratorsFor(const World& world, const State& initial);

/// Measures an integrator over a ladder of steps: the scene's own, doubled until the motion is lost
/// or the integrator divides the steps itself, and halved until rounding or patience ends it. Which
/// steps these are is counted, not timed.
/// measured is called with each setting as soon as it is known.
void climbLadder(const World& world, const Reference& reference, const std::string& integrator,
                 const std::function<void(const Setting&)>& measured,
                 const Patience& patience = {});

}  // namespace rigid_body_sim
