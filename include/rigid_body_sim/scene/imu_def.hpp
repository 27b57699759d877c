#pragma once

#include <rigid_body_sim/dynamics/imu.hpp>

namespace rigid_body_sim {

/// An IMU as a scene describes it; its body is the one that names it.
struct ImuDef {
  Imu imu;
  int line = 0;  ///< of its name in the file, 0 in a scene made by a program
};

}  // namespace rigid_body_sim
