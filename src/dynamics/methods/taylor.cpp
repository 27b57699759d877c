#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/methods/catalogue.hpp"
#include "dynamics/taylor/driven_segment.hpp"

namespace rigid_body_sim {
namespace {

void advanceMotors(const System& system, double h, SystemState& states) {
  for (const System::Driven& driven : system.driven) {
    BodyState& s = states.bodies[driven.body];
    const HeldWrench& held = system.held[driven.body];
    const Body& body = *system.bodies[driven.body];
    double& since = states.laws[driven.state];
    s = held.drive ? advanceDriven(body, held, system.g_W, s, since, h)
                   : advanceTaylor(body, held, system.g_W, s, h);
    since += h;
  }
}

}  // namespace

// Each body by Taylor segments of its own. The wrenches enter the series once a segment, which is
// counted as one evaluation a step.
void taylorStep(const System& system, double h, SystemState& states, Workspace& workspace) {
  if (!system.driven.empty()) {
    advanceMotors(system, h, states);
  } else {
    for (std::size_t i = 0; i < states.bodies.size(); ++i)
      states.bodies[i] =
          advanceTaylor(*system.bodies[i], system.held[i], system.g_W, states.bodies[i], h);
  }
  ++workspace.evaluations;
  workspace.wrenches_current = false;
}

}  // namespace rigid_body_sim
