#pragma once

#include <array>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

constexpr std::size_t kMotionNumbers = 13;

/// Position [m], quaternion, velocity [m/s] and angular velocity [rad/s] of a body frame in the
/// world: the numbers of a row of kCsvHeader.
inline std::array<double, kMotionNumbers> motionNumbers(const BodyFrameMotion& m) {
  return {m.x_W.x(), m.x_W.y(), m.x_W.z(), m.q_WB.x(), m.q_WB.y(), m.q_WB.z(), m.q_WB.w(),
          m.v_W.x(), m.v_W.y(), m.v_W.z(), m.w_W.x(),  m.w_W.y(),  m.w_W.z()};
}

}  // namespace rigid_body_sim
