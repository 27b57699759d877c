#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {

/// Bodies that act on one another, with the laws between them.
struct CoupledBodies {
  std::vector<std::size_t> members;  ///< indices in the world, ascending
  ForceLaws laws;                    ///< of the world, by its indices
};

/// Splits the bodies that move into groups that do not act on one another: two bodies are in one
/// group when a chain of bonds (sets of body indices) links them. Fixed bodies are in none and link
/// nothing. Groups ascend by their first member.
std::vector<std::vector<std::size_t>> linkedBodies(
    const std::vector<Body>& bodies, const std::vector<std::vector<std::size_t>>& bonds);

/// The groups of a world: linked by laws, and by wrenches that turn with another body.
std::vector<CoupledBodies> coupledBodies(const World& world,
                                         const std::vector<WrenchSchedule>& schedules);

/// What a method must accept to advance the group (Need).
unsigned needsOf(const World& world, const CoupledBodies& group,
                 const std::vector<WrenchSchedule>& schedules);

/// Throws std::invalid_argument, naming the body, where the world's integrator is unknown or does
/// not take what acts on one of its groups. For a world whose integrator is not auto.
void requireTaken(const World& world);

}  // namespace rigid_body_sim
