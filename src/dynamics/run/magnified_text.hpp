#pragma once

#include <string>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// That the motion of a body has spread out the last digit of its start; and what holds of it, of a
/// rotation in closed form or of one that is solved by series, piece by piece: of the latter, the
/// rounding of each piece is magnified, too.
enum class SolvedBy { kClosedForm, kSeries };
std::string magnifiedText(const Body& body, double magnification, SolvedBy solved);

}  // namespace rigid_body_sim
