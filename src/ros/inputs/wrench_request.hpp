#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// What a wrench message asks for, by the names of bodies and frames that its sender used. Both
/// doors of the node are brought to this form.
struct WrenchRequest {
  WrenchDef wrench;  ///< times in simulation time; start in the past: the next step; duration 0:
                     ///< until replaced, cleared or timed out
  std::string slot;  ///< replaces what the body has under it; empty: always adds
  /// From <body>/wrench: `frame` gives the place too. The world: the centre of mass of the body.
  /// The body or a frame fixed to it: that frame's origin. No other frame will do.
  bool placed_by_frame = false;
};

}  // namespace rigid_body_sim
