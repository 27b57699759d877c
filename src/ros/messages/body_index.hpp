#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// Index of the body of that name, as messages give it. Throws std::invalid_argument, one line, for
/// an unknown one.
std::size_t bodyNamed(const std::string& name, const std::vector<Body>& bodies);

}  // namespace rigid_body_sim
