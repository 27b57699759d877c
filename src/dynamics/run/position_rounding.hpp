#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// [m] What rounding may do to the place of each body of a world: where its centre of mass rests
/// but for rounding, a gap like that is no share of its path. Positions are carried in two parts,
/// so that not the distance from the origin counts but the lengths that laws subtract positions
/// over:
///   4 ε (radius of gyration + Σ reach of the laws on the body)
/// law_states: State::laws, or empty for laws as they start.
std::vector<double> positionRounding(const World& world, const std::vector<BodyState>& states,
                                     const std::vector<double>& law_states);

}  // namespace rigid_body_sim
