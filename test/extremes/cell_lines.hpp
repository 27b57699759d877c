#pragma once

#include "cell.hpp"

namespace rigid_body_sim::extremes {

/// Prints cells as lines of CSV. Returns whether every cell says something: errors that are
/// numbers, or what stopped the run.
bool print(const Cells& cells);

}  // namespace rigid_body_sim::extremes
