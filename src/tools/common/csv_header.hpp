#pragma once

namespace rigid_body_sim {

/// The first line of a CSV file of simulate: time [s], body, position [m], quaternion, velocity
/// [m/s] and angular velocity [rad/s] in the world.
constexpr const char* kCsvHeader = "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz";

}  // namespace rigid_body_sim
