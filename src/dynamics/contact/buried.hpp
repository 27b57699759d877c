#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// A body that is put wholly below a plane which it touches. What lies so deep would be thrown out
/// as by a catapult, or creep out along a force so stiff that no run comes to its end.
struct BuriedBody {
  std::size_t body;
  std::string fault;  ///< "body 'box': position must ..."
};

/// The first of all bodies, by the order of the laws; nothing where there is none.
std::optional<BuriedBody> findBuried(const World& world, const std::vector<BodyState>& states);

/// Throws std::invalid_argument where one is buried.
void requireNoneBuried(const World& world, const std::vector<BodyState>& states);

/// The same where that body is, in this state.
void requireNotBuried(const World& world, std::size_t body, const BodyState& state);

}  // namespace rigid_body_sim
