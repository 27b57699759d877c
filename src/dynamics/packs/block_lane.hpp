#pragma once

#include <iterator>

#include "dynamics/packs/packs.hpp"

/// One body of a block.
namespace rigid_body_sim {

/// A block of bodies that stand still, so that lanes without a body are stepped without harm.
PackBlock emptyBlock();

/// Writes all columns of a lane; h [s]: the step.
void putBody(const SteadyMotion& motion, PackKind kind, double h, const BodyState& state,
             PackBlock& block, std::size_t lane);

/// Writes all columns of a lane, where anything acts beside a force at the centre of mass.
PackLoad putPush(const SteadyMotion& motion, double h, PushBlock& block, std::size_t lane);

inline BodyState bodyIn(const PackBlock& block, std::size_t lane) {
  BodyState state;
  copyState(block.columns, lane, state);
  return state;
}

template <class Block>
void copyLane(const Block& from, std::size_t from_lane, Block& to, std::size_t to_lane) {
  for (std::size_t c = 0; c < std::size(from.columns); ++c)
    to.columns[c][to_lane] = from.columns[c][from_lane];
}

/// What is certain for Packs::kCertainSteps steps: that a body turns in none of them further than
/// its integrator follows without dividing it, and that its numbers remain finite.
bool isCertain(const PackBlock& block, std::size_t lane);

/// And that drag slows it down in none of them faster than that.
bool slowsSlowly(const PackBlock& block, const PushBlock& push, std::size_t lane);

/// Whether the numbers that stay the same allow that, for ever.
bool staysModest(const PackBlock& block, std::size_t lane);
bool staysModest(const PushBlock& block, std::size_t lane);

/// isCertain of the first bodies of a block.
bool areCertain(const PackBlock& block, std::size_t bodies);

}  // namespace rigid_body_sim
