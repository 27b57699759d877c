#pragma once

#include <string>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// That the motion of a body, solved as it is, has spread out the last digit of its start.
std::string magnifiedText(const Body& body, double magnification);

}  // namespace rigid_body_sim
