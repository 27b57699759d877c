#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// X_AB of a frame B with its origin at position_A and the attitude q_AB, unit.
inline Isometry3d isometry(const Quaterniond& q_AB, const Vector3d& position_A) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = q_AB.toRotationMatrix();
  X.translation() = position_A;
  return X;
}

}  // namespace rigid_body_sim
