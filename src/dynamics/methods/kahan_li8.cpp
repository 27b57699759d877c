#include "dynamics/methods/kick_drift.hpp"

namespace rigid_body_sim {

// Seventeen Strang steps of lengths that cancel every error term up to order 8.
// Source: Kahan & Li, Math. Comp. 66 (1997) 1089; Hairer, Lubich & Wanner, Geometric Numerical
// Integration, 2nd ed., V.3.2.
void kahanLi8Step(const System& system, double h, SystemState& states, Workspace& workspace) {
  constexpr double g1 = 0.13020248308889008088, g2 = 0.56116298177510838456,
                   g3 = -0.38947496264484728641, g4 = 0.15884190655515560090,
                   g5 = -0.39590389413323757734, g6 = 0.18453964097831570709,
                   g7 = 0.25837438768632204729, g8 = 0.29501172360931029887,
                   g9 = -0.60550853383003451170;
  constexpr auto kKahanLi = methods::composition<17>(
      {g1, g2, g3, g4, g5, g6, g7, g8, g9, g8, g7, g6, g5, g4, g3, g2, g1});
  methods::kickDriftKick(kKahanLi, methods::SplitDrift(), system, h, states, workspace);
}

}  // namespace rigid_body_sim
