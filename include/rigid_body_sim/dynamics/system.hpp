#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/held_wrench.hpp>

namespace rigid_body_sim {

/// Bodies that act on one another, with all that acts on them between two events. What is absent
/// from the scene is absent here.
struct System {
  std::vector<const Body*> bodies;
  Vector3d g_W = Vector3d::Zero();     ///< [m/s²]
  std::vector<HeldWrench> held;        ///< one per body
  std::vector<AppliedWrench> coupled;  ///< whose axes or point turn with another body; indices are
                                       ///< those of this system
};

/// The wrench on each body, gravity included.
void wrenchesAt(const System& system, const std::vector<BodyState>& states,
                std::vector<Wrench>& wrenches);

}  // namespace rigid_body_sim
