#pragma once

#include <string>

#include "tools/sweep/sweep_summary.hpp"

namespace rigid_body_sim {

/// What stands in the first lines of the picture, and in that of no other program.
constexpr const char* kPlotMark = "<title>rigid_body_sim_sweep</title>";

/// Draws up to three results: how they are distributed, each against the varied value that it goes
/// most with, and the fan of a quantity over time from fan.csv. Returns the picture. Throws
/// std::runtime_error where gnuplot fails.
std::string sweepPlot(const SweepSummary& summary, const SweepInfo& info,
                      const std::string& fan_csv);

}  // namespace rigid_body_sim
