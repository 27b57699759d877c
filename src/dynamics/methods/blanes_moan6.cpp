#include "dynamics/methods/kick_drift.hpp"
#include "dynamics/rotation/free_flight.hpp"

namespace rigid_body_sim {

// Drifts and kicks in turn, of order 6 with small error terms. It takes for granted that the
// kinetic energy is quadratic in the momenta and that drifts are exact, as the free top's are.
// Source: Blanes & Moan, J. Comput. Appl. Math. 142 (2002) 313, SRKN 14A.
void blanesMoan6Step(const System& system, double h, SystemState& states, Workspace& workspace) {
  constexpr double a1 = 0.0378593198406116, a2 = 0.102635633102435, a3 = -0.0258678882665587,
                   a4 = 0.314241403071447, a5 = -0.130144459517415, a6 = 0.106417700369543,
                   a7 = -0.00879424312851058, a8 = 0.2073050690568954;
  constexpr double b1 = 0.09171915262446165, b2 = 0.183983170005006, b3 = -0.05653436583288827,
                   b4 = 0.004914688774712854, b5 = 0.143761127168358, b6 = 0.328567693746804,
                   b7 = -0.19641146648645423;
  constexpr methods::DriftKickDrift<14> kBlanesMoan{
      {a1, a2, a3, a4, a5, a6, a7, a8, a7, a6, a5, a4, a3, a2, a1},
      {b1, b2, b3, b4, b5, b6, b7, b7, b6, b5, b4, b3, b2, b1}};
  const auto drift = [](const Body& body, double step, BodyState& s) {
    s = flownFreely(body, s, step);
  };
  methods::driftKickDrift(kBlanesMoan, drift, system, h, states, workspace);
}

}  // namespace rigid_body_sim
