#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// Engines that let a body touch the ground z = 0, by the contact that each of them has. Each
/// registers itself from its own file.
namespace rigid_body_sim::touch_peers {

using Array3 = std::array<double, 3>;
using Quaternion4 = std::array<double, 4>;  ///< x y z w, unit

/// A body of 1 kg under gravity: a ball, a box or an ellipsoid.
struct TouchCase {
  std::string name;
  double radius = 0;           ///< [m] of a ball; 0: none
  Array3 box{};                ///< [m] its edges
  Array3 semi_axes{};          ///< [m] of an ellipsoid; 0: none
  double shape_up = 0;         ///< [m] its centre, along z of the principal axes
  double shape_turn = 0;       ///< [rad] of its axes in the principal ones, about z
  Array3 inertia{};            ///< [kg m²] of an ellipsoid; others are homogeneous
  Array3 x_W{}, v_W{}, w_W{};  ///< [m], [m/s], [rad/s]
  Array3 rotation{};           ///< rotation vector of the start
  double friction = 0;
  double restitution = 0;
  double duration = 0;     ///< [s]
  bool has_truth = false;  ///< of rigid bodies under Coulomb's law
  Array3 truth{};          ///< [m] where its centre is at the end
  Quaternion4 attitude{};  ///< true one of an ellipsoid at the end

  bool isEllipsoid() const { return semi_axes[0] > 0; }
};

constexpr double kGravity = 9.80665;  // [m/s²]

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kPatience = 20;  // [s] of processor time of a run; the ladder ends there

struct TouchRun {
  std::string setting;
  double seconds = 0;                     ///< of processor time
  Array3 x_W{};                           ///< [m] at the end
  Quaternion4 q{kNaN, kNaN, kNaN, kNaN};  ///< of the principal axes at the end; for ellipsoids
};

/// One engine with one of its solvers: steps of h [s], or what else its setting is.
struct TouchEngine {
  const char* name;
  std::vector<double> settings;  ///< none: for ellipsoids only
  TouchRun (*run)(const TouchCase&, double setting);
  std::vector<double> settings_of_ellipsoids;
};

/// All that are linked in.
std::vector<TouchEngine>& touchEngines();

struct TouchRegistration {
  explicit TouchRegistration(const TouchEngine& engine) { touchEngines().push_back(engine); }
};

/// [m] From the centre of mass to the lowest point of an ellipsoid; down_P: unit, in principal
/// axes.
Array3 lowestPoint(const TouchCase& c, const Array3& down_P);

/// [rad] NaN where one of them is.
double angleBetween(const Quaternion4& a, const Quaternion4& b);

/// A rattleback that is spun, and where it is after it has rolled.
TouchCase rattleback();

/// Steps from a hundredth of a second down.
inline const std::vector<double> kSteps{1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5};
/// The same for a rattleback, whose errors grow.
inline const std::vector<double> kFineSteps{1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6, 2e-6};

}  // namespace rigid_body_sim::touch_peers
