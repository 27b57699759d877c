#pragma once

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// [1/kg] At most how much a force at a point r of a body accelerates the point, per newton:
///   1/m + Σ |r × eᵢ|²/Iᵢ
inline double mobilityAt(const Body& body, const Vector3d& point_P) {
  double sum = 1 / body.mass;
  for (int i = 0; i < 3; ++i) sum += point_P.cross(Vector3d::Unit(i)).squaredNorm() * body.inv_I(i);
  return sum;
}

}  // namespace rigid_body_sim
