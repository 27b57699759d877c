#pragma once

#include <array>
#include <string>
#include <vector>

/// Engines that take the same cases as ours. Each registers itself from its own file, so that those
/// that are not installed are simply not there. No Eigen here: odeint's file is compiled for
/// another instruction set, and inline functions of both would be mixed up.
namespace rigid_body_sim::peers {

using Quaternion4 = std::array<double, 4>;  // x y z w, unit

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
  Quaternion4 truth{};            ///< attitude at the end

  bool isPushed() const { return force_W != std::array<double, 3>{}; }
};

/// A run: what it took and where it ended.
struct Run {
  std::string setting;
  double seconds = 0;  ///< of processor time
  Quaternion4 q{};     ///< attitude at the end
};

/// [rad] between the end of a run and the truth; NaN where the run lost the finite numbers.
double errorOf(const Run& run, const Problem& problem);

/// Attitude errors [rad] whose cost is asked for.
constexpr std::array<double, 4> kTargets{1e-2, 1e-4, 1e-6, 1e-9};

struct Engine {
  const char* name;
  std::vector<Run> (*runs)(const Problem&);  ///< over ladders of all that it can be set to
};

/// All that are linked in.
std::vector<Engine>& engines();

struct Registration {
  explicit Registration(const Engine& engine) { engines().push_back(engine); }
};

std::string label(const std::string& method, const char* what, double value);

}  // namespace rigid_body_sim::peers
