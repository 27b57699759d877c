#include <rigid_body_sim/dynamics/catalogue.hpp>
#include <rigid_body_sim/dynamics/free_motion.hpp>

namespace rigid_body_sim {
namespace {

void kickAll(double h, const std::vector<Wrench>& wrenches, std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i)
    kick(wrenches[i].f_W, wrenches[i].tau_W, wrenches[i].tau_P, h, states[i]);
}

}  // namespace

// kick h/2, free motion h, kick h/2 (Strang, SIAM J. Numer. Anal. 5 (1968) 506). The wrenches at
// the end of a step are those at the start of the next: one evaluation a step.
void strangStep(const System& system, double h, std::vector<BodyState>& states,
                Workspace& workspace) {
  if (!workspace.wrenches_current) evaluateWrenches(system, states, workspace);
  kickAll(0.5 * h, workspace.wrenches, states);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Body& body = *system.bodies[i];
    driftPosition(body.mass, h, states[i]);
    driftRotation(body.split, h, states[i]);
  }
  evaluateWrenches(system, states, workspace);
  kickAll(0.5 * h, workspace.wrenches, states);
  workspace.wrenches_current = true;
}

}  // namespace rigid_body_sim
