#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/wrench.hpp>

#include "support/reference_motion.hpp"

namespace rigid_body_sim::reference {

/// The load of gravity and of wrenches applied to one body, whatever their axes and points among
/// the world's and its own; starts and ends are not looked at.
inline auto appliedLoad(const Body& body, const Vector3d& g_W,
                        const std::vector<PointWrench>& applied) {
  return [=](Real, const Motion& m) {
    const Matrix R = m.R();
    Load load;
    load.f_W = Real(body.mass) * g_W.cast<Real>();
    for (const PointWrench& a : applied) {
      const bool own_axes = a.axes != kWorld, own_point = a.point_frame != kWorld;
      const Vector force = a.force.cast<Real>();
      const Vector torque = a.torque.cast<Real>();
      const Vector point = a.point.cast<Real>();
      load.f_W += own_axes ? Vector(R * force) : force;
      if (own_axes) {
        load.tau_P += point.cross(force) + torque;
      } else {
        load.tau_W += (own_point ? Vector(R * point) : Vector(point - m.x)).cross(force) + torque;
      }
    }
    return load;
  };
}

}  // namespace rigid_body_sim::reference
