#include "dynamics/methods/catalogue.hpp"
#include "dynamics/taylor/taylor_segment.hpp"

namespace rigid_body_sim {

// Each body by Taylor segments of its own. The wrenches enter the series once a segment, which is
// counted as one evaluation a step.
void taylorStep(const System& system, double h, SystemState& states, Workspace& workspace) {
  for (std::size_t i = 0; i < states.bodies.size(); ++i)
    states.bodies[i] =
        advanceTaylor(*system.bodies[i], system.held[i], system.g_W, states.bodies[i], h);
  ++workspace.evaluations;
  workspace.wrenches_current = false;
}

}  // namespace rigid_body_sim
