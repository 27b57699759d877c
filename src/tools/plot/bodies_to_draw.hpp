#pragma once

#include <string>
#include <vector>

#include "tools/plot/run_data.hpp"

namespace rigid_body_sim {

/// The bodies to draw by default: the first eight that move, in the order of the run; where none
/// moves, the first eight.
std::vector<std::string> bodiesToDraw(const RunData& run);

/// The names of all bodies, and of those whose motion is not the same throughout.
std::vector<std::string> bodiesOf(const RunData& run);
std::vector<std::string> movingBodies(const RunData& run);

/// A body that turns further than half a turn from one sample to the next, so that its angles may
/// miss whole turns; empty: there is none.
std::string bodyThatTurnsTooFar(const RunData& run, const std::vector<std::string>& bodies);

}  // namespace rigid_body_sim
