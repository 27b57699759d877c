#pragma once

#include <cstddef>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

struct World;
struct State;

/// A feature of a body that touches another now.
struct ContactPoint {
  std::size_t body = 0;                          ///< index, the body acted on
  std::size_t other = 0;                         ///< index, or kWorld: −force acts on it
  Vector3d position_W = Vector3d::Zero();        ///< [m] where the force acts
  Vector3d normal_force_W = Vector3d::Zero();    ///< [N] on `body`
  Vector3d friction_force_W = Vector3d::Zero();  ///< [N] on `body`
  double penetration = 0;                        ///< [m] the greatest, of a rim
  bool slips = false;
};

/// A feature touched, or let go.
struct ContactEvent {
  double t = 0;                            ///< [s] since the start of the simulation
  std::size_t body = 0;                    ///< index
  std::size_t other = 0;                   ///< index, or kWorld
  bool touch = true;                       ///< else: release
  Vector3d position_W = Vector3d::Zero();  ///< [m]
};

/// Whether a law of the world is one of contact.
bool hasContact(const World& world);

/// Whether a law of the world begins and ceases to act where its bodies go, as a contact or a
/// tether does (ForceLaw::isOneSided).
bool hasOneSidedLaw(const World& world);

/// Everything that touches in a state, law by law in the order of World::laws. Empty for a state
/// without the states of laws: take one that a simulation gave. Throws std::invalid_argument for a
/// state that cannot be one of the world.
std::vector<ContactPoint> contactsOf(const World& world, const State& state);

}  // namespace rigid_body_sim
