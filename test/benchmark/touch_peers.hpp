#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

/// Engines that let a body touch the ground z = 0, by the contact that each of them has. Each
/// registers itself from its own file.
namespace rigid_body_sim::touch_peers {

using Array3 = std::array<double, 3>;

/// A body of 1 kg, without attitude at the start, under gravity.
struct TouchCase {
  std::string name;
  double radius = 0;           ///< [m] of a ball; 0: a box
  Array3 box{};                ///< [m] its edges
  Array3 x_W{}, v_W{}, w_W{};  ///< [m], [m/s], [rad/s]
  Array3 rotation{};           ///< rotation vector of the start
  double friction = 0;
  double restitution = 0;
  double duration = 0;     ///< [s]
  bool has_truth = false;  ///< of rigid bodies under Coulomb's law
  Array3 truth{};          ///< [m] where its centre is at the end
};

constexpr double kGravity = 9.80665;  // [m/s²]

struct TouchRun {
  std::string setting;
  double seconds = 0;  ///< of processor time
  Array3 x_W{};        ///< [m] at the end
};

/// One engine with one of its solvers: steps of h [s], or what else its setting is.
struct TouchEngine {
  const char* name;
  std::vector<double> settings;
  TouchRun (*run)(const TouchCase&, double setting);
};

/// All that are linked in.
std::vector<TouchEngine>& touchEngines();

struct TouchRegistration {
  explicit TouchRegistration(const TouchEngine& engine) { touchEngines().push_back(engine); }
};

/// Steps from a hundredth of a second down.
inline const std::vector<double> kSteps{1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5};

}  // namespace rigid_body_sim::touch_peers
