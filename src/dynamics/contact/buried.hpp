#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Throws std::invalid_argument for a body that is put wholly below a plane which it touches. What
/// lies so deep would be thrown out as by a catapult, or creep out along a force so stiff that no
/// run comes to its end.
void requireNotBuried(const World& world, std::size_t body, const BodyState& state);

/// The same for all bodies.
void requireNoneBuried(const World& world, const std::vector<BodyState>& states);

}  // namespace rigid_body_sim
