#pragma once

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/entry.hpp"

namespace rigid_body_sim {

/// Notes a body whose numbers are possible and look like a common mistake: an angular velocity in
/// degrees, a quaternion that begins with w. entry: the body's mapping.
void noteSuspicious(const Entry& entry, const BodyDef& body);

/// What was noted, one notice of each kind.
std::vector<std::string> suspicions(const ReadContext& context);

}  // namespace rigid_body_sim
