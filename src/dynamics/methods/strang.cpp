#include "dynamics/methods/kick_drift.hpp"

namespace rigid_body_sim {

// kick h/2, free motion h, kick h/2. Source: Strang, SIAM J. Numer. Anal. 5 (1968) 506.
void strangStep(const System& system, double h, SystemState& states, Workspace& workspace) {
  constexpr methods::KickDriftKick<1> kStrang{{0.5, 0.5}, {1}};
  methods::kickDriftKick(kStrang, methods::SplitDrift(), system, h, states, workspace);
}

}  // namespace rigid_body_sim
