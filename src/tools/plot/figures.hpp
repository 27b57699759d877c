#pragma once

#include <string>
#include <vector>

#include "tools/plot/figure.hpp"
#include "tools/plot/run_data.hpp"

namespace rigid_body_sim {

/// The figures of what a run holds; none of forces that are zero throughout. bodies: those that are
/// drawn.
std::vector<Figure> figuresOf(const RunData& run, const std::vector<std::string>& bodies);

/// Of those, the ones of energy and momentum; none where the run does not hold these.
std::vector<Figure> balanceFigures(const RunData& run);

}  // namespace rigid_body_sim
