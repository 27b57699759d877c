#pragma once

#include <vector>

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// Whatever acts on a body on a pivot by then, the pivot holds its point in place: its force takes
/// the others up, and has no torque about the point.
inline void takeUpForces(const System& system, std::vector<Wrench>& wrenches) {
  for (const System::Pivot& pivot : system.pivots) wrenches[pivot.body].f_W.setZero();
}

/// What is held on a body on a pivot, with gravity at its centre of mass: torques about the pivot
/// and no force. Leaves the forces in pivot.
HeldWrench heldOnPivot(const Body& body, HeldWrenchSum wrenches, System::Pivot& pivot);

/// [N] All forces but the pivot's on each body of system.pivots, gravity included.
std::vector<Vector3d> forcesOnPivoted(const System& system, const SystemState& states);

}  // namespace rigid_body_sim
