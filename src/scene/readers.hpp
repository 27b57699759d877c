#pragma once

#include <rigid_body_sim/scene/scene.hpp>

#include "entry.hpp"

namespace rigid_body_sim {

BodyDef readBody(const Entry& entry);
Shape readShape(const Entry& entry);
WrenchDef readWrench(const Entry& entry);

}  // namespace rigid_body_sim
