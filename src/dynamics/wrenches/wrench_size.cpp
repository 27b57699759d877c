#include "dynamics/wrenches/wrench_size.hpp"

#include <cmath>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/shortest.hpp"

namespace rigid_body_sim {

/// By sizes, not by the cross product: parallel to its arm, a force would leave a difference of two
/// infinite numbers.
std::string wrenchSizeFault(const PointWrench& wrench) {
  const double force = stableNorm(wrench.force), torque = stableNorm(wrench.torque);
  const double arm = stableNorm(wrench.point);
  if (!std::isfinite(force)) return "force must have a finite magnitude";
  if (!std::isfinite(torque)) return "torque must have a finite magnitude";
  if (!std::isfinite(arm)) return "point must be at a finite distance";
  if (std::isfinite(arm * force + torque)) return "";
  return "the torque of the force must be finite, got " + shortest(force) + " N at " +
         shortest(arm) + " m" + (torque > 0 ? ", with " + shortest(torque) + " N m" : "");
}

}  // namespace rigid_body_sim
