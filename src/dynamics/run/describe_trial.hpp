#pragma once

#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What the trial of contacts and tethers has found (see ContactTrial), in words; empty where there
/// is nothing to report.
std::string describeTrial(const Simulation& simulation);

}  // namespace rigid_body_sim
