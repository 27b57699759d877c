#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// Splits the bodies that move into groups that do not act on one another: two bodies are in one
/// group when a chain of bonds (sets of body indices) links them. Fixed bodies are in none and link
/// nothing. Members ascend within a group, groups ascend by their first member.
std::vector<std::vector<std::size_t>> coupledGroups(
    const std::vector<Body>& bodies, const std::vector<std::vector<std::size_t>>& bonds);

}  // namespace rigid_body_sim
