#pragma once

#include "dynamics/run/run.hpp"

namespace rigid_body_sim {

/// Whether auto has to find out what a stated tolerance asks of contacts and tethers of the scene.
bool needsContactTrial(const Run& run);

/// Runs the scene from the start at ever tighter bounds; see ContactTrial.
ContactTrial tryContact(const Run& run);

}  // namespace rigid_body_sim
