#pragma once

#include <array>
#include <string>
#include <vector>

namespace rigid_body_sim::peers {

/// One body that starts at rest in place, with its principal axes along the world's.
struct Problem {
  const char* name;
  double mass;                    ///< [kg]
  std::array<double, 3> I;        ///< [kg m²]
  std::array<double, 3> w;        ///< [rad/s] at the start
  std::array<double, 3> g_W;      ///< [m/s²]
  std::array<double, 3> force_W;  ///< [N], constant
  std::array<double, 3> arm_P;    ///< [m] where the force acts, fixed in the body
  double duration;                ///< [s]
};

/// A run of a peer: what it took and where it ended.
struct Run {
  std::string setting;
  double seconds = 0;         ///< of processor time
  std::array<double, 4> q{};  ///< attitude at the end, x y z w, unit
};

/// Boost.odeint with rk4, dopri5, rkf78 in fixed and controlled steps and with Bulirsch–Stoer, each
/// over a ladder of steps or tolerances.
std::vector<Run> odeintRuns(const Problem& problem);

}  // namespace rigid_body_sim::peers
