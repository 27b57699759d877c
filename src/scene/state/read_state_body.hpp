#pragma once

#include <string>
#include <unordered_map>

#include <rigid_body_sim/dynamics/world.hpp>

#include "scene/readers/entry.hpp"

namespace rigid_body_sim {

/// The bodies of a world by their names.
using BodyIndex = std::unordered_map<std::string, std::size_t>;

/// Reads one entry of `bodies` of a saved state into the places of a body of the world, which the
/// state must have. Throws SceneError.
void readStateOfBody(const Entry& entry, const World& world, const BodyIndex& index,
                     std::size_t body, State& state);

/// The name of a body of the world; its index.
std::size_t readBodyName(const Entry& value, const BodyIndex& index);

/// A whole number >= 0 below 2⁵³.
std::size_t readCount(const Entry& value);

}  // namespace rigid_body_sim
