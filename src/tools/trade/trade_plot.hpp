#pragma once

#include <string>

#include "tools/trade/trade_report.hpp"

namespace rigid_body_sim {

/// Draws error against cost, log-log, a line per integrator, with the Pareto front, the error
/// budget, and the scene's present setting. Settings that cannot be drawn are
/// left out. Throws std::runtime_error where gnuplot fails.
void plotTrade(const Trade& trade, const std::string& svg_path);

}  // namespace rigid_body_sim
