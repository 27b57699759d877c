#pragma once

namespace rigid_body_sim {

/// The first line of a CSV file of simulate: time [s], body, position [m], quaternion, velocity
/// [m/s] and angular velocity [rad/s] in the world.
constexpr const char* kCsvHeader = "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz";

/// The same of the forces on the bodies: all but uniform gravity, with the reactions of motors;
/// force [N], torque [N m] about the centre of mass, or about the pivot; world axes.
constexpr const char* kForcesHeader = "time,body,fx,fy,fz,tx,ty,tz";

/// The same of all bodies together: mechanical energy, the kinetic energy in it and the work done
/// [J], momentum [kg m/s] and angular momentum [kg m²/s] as Totals, and what the exchange with the
/// surroundings does not account for of the first and the last two (Simulation::balance).
constexpr const char* kBalanceHeader =
    "time,energy,kinetic_energy,work,px,py,pz,lx,ly,lz,energy_balance,"
    "px_balance,py_balance,pz_balance,lx_balance,ly_balance,lz_balance";

}  // namespace rigid_body_sim
