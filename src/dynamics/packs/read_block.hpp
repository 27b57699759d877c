#pragma once

#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/packs/pack_block.hpp"

namespace rigid_body_sim {

/// Writes the states of all bodies of a block, each to its place.
using ReadBlock = void (*)(const PackBlock& block, BodyState* const* states);

/// The quickest that this processor can run.
ReadBlock readBlock();

/// One body after the other, on every processor.
void readBlockNarrow(const PackBlock& block, BodyState* const* states);

}  // namespace rigid_body_sim
