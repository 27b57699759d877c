#pragma once

#include <string>

#include <rigid_body_sim/scene/frames.hpp>

namespace rigid_body_sim {

struct ResolvedWrench {
  PointWrench wrench;  ///< valid only where fault is empty
  std::string fault;   ///< one line saying which rule is broken and what was found; empty if none
};

/// A wrench given by names, in the frames in which the core holds it:
///   force_P = R_PF force_F,  torque_P = R_PF torque_F,  point_P = X_PG point_G,
/// with F the frame, G the point frame, and P the principal frame of the body to which each is
/// fixed, or the world. Faults: unknown or fixed body, unknown frame, numbers that are not finite,
/// a duration that is not > 0 (infinite is allowed) or too short to move the clock from start.
ResolvedWrench resolveWrench(const WrenchDef& wrench, const std::vector<Body>& bodies,
                             const FrameTable& frames);

}  // namespace rigid_body_sim
