#include "tools/common/require_motion.hpp"

#include <cmath>
#include <stdexcept>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/shortest.hpp"

namespace rigid_body_sim {

void requireMotion(const std::array<double, 13>& motion) {
  for (const double x : motion)
    if (!std::isfinite(x)) throw std::runtime_error("position or velocity is not finite");
  const Quaterniond q(motion[6], motion[3], motion[4], motion[5]);
  if (!isNearlyUnit(q))
    throw std::runtime_error("the norm of the quaternion must be 1, got " + shortest(q.norm()));
}

}  // namespace rigid_body_sim
