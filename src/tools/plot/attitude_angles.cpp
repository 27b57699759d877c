#include "tools/plot/attitude_angles.hpp"

#include <algorithm>
#include <cmath>

#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

Vector3d rollPitchYaw(const Quaterniond& q) {
  const double sine = 2 * (q.w() * q.y() - q.z() * q.x());
  return {std::atan2(2 * (q.w() * q.x() + q.y() * q.z()), 1 - 2 * (q.x() * q.x() + q.y() * q.y())),
          std::asin(std::clamp(sine, -1.0, 1.0)),
          std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()))};
}

Vector3d nearestTurn(const Vector3d& angles, const Vector3d& to) {
  Vector3d near;
  for (int i = 0; i < 3; ++i)
    near[i] = angles[i] + 2 * kPi<double> * std::round((to[i] - angles[i]) / (2 * kPi<double>));
  return near;
}

}  // namespace

Vector3d AttitudeAngles::next(const Quaterniond& q_WB) {
  const Vector3d a = rollPitchYaw(q_WB.normalized());
  if (is_first_) {
    is_first_ = false;
    return last_ = a;
  }
  const Vector3d direct = nearestTurn(a, last_);
  const Vector3d over =
      nearestTurn({a.x() + kPi<double>, kPi<double> - a.y(), a.z() + kPi<double>}, last_);
  last_ = (direct - last_).squaredNorm() <= (over - last_).squaredNorm() ? direct : over;
  return last_;
}

}  // namespace rigid_body_sim
