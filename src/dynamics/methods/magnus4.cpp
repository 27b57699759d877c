#include "dynamics/methods/kick_drift.hpp"

namespace rigid_body_sim {

// kick h/2, free motion h by one exponential of fourth order, kick h/2
void magnus4Step(const System& system, double h, SystemState& states, Workspace& workspace) {
  constexpr methods::KickDriftKick<1> kStrang{{0.5, 0.5}, {1}};
  const auto drift = [](const Body& body, double step, BodyState& s) {
    driftPosition(body.mass, step, s);
    driftMagnus(body.inv_I, step, s);
  };
  methods::kickDriftKick(kStrang, drift, system, h, states, workspace);
}

}  // namespace rigid_body_sim
