#pragma once

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Roll, pitch and yaw [rad] of attitudes one after another, R = R_z(yaw) R_y(pitch) R_x(roll),
/// that go on from those before: of all triples that mean the attitude,
///   (roll, pitch, yaw) and (roll + π, π − pitch, yaw + π), each up to whole turns,
/// the nearest to the triple before. So no angle jumps, and pitch goes on beyond a quarter of a
/// turn, as long as the body turns less than half a turn between two attitudes.
class AttitudeAngles {
 public:
  Vector3d next(const Quaterniond& q_WB);

  /// What comes next does not go on from what came before.
  void startAnew() { is_first_ = true; }

 private:
  Vector3d last_ = Vector3d::Zero();
  bool is_first_ = true;
};

}  // namespace rigid_body_sim
