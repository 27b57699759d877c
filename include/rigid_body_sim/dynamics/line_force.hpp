#pragma once

#include <cstddef>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

struct World;
struct State;

/// What a spring or a tether exerts now, along the line between its ends.
struct LineForce {
  struct End {
    std::size_t body = 0;                    ///< index, or kWorld
    Vector3d position_W = Vector3d::Zero();  ///< [m]
  };

  std::size_t law = 0;  ///< index in World::laws
  End from, to;
  double length = 0;   ///< [m]
  double tension = 0;  ///< [N] > 0: it pulls its ends towards each other; < 0: it pushes them apart
  bool is_slack = false;  ///< of a tether: slack or limp, its tension is 0
};

/// Whether the world has a spring or a tether.
bool hasLines(const World& world);

/// Those of all springs and tethers, in the order of World::laws. Throws std::invalid_argument for
/// a state without the states of laws that have some: take one that a simulation gave; and for one
/// that cannot be of the world.
std::vector<LineForce> lineForcesOf(const World& world, const State& state);

}  // namespace rigid_body_sim
