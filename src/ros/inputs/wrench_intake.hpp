#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/resolve_wrench.hpp>

#include "ros/inputs/wrench_request.hpp"

namespace rigid_body_sim {

/// What a request is judged by.
struct IntakeRules {
  std::string world_frame;
  double wrench_timeout;  ///< [s] after its start, a wrench of duration 0 ends; 0: never
};

/// Turns a request that arrives at simulation time `now` [s], a step boundary, into a wrench for
/// the core; or into a fault, one line, for what names nothing known, is not finite, lasts a
/// negative time, is held without a slot to replace it, has an id that is too long, or comes to
/// <body>/wrench in a frame that is neither the world's nor fixed to that body.
ResolvedWrench takeWrench(const WrenchRequest& request, const std::vector<Body>& bodies,
                          const FrameTable& frames, const IntakeRules& rules, double now);

}  // namespace rigid_body_sim
