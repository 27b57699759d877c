#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

/// Index of the body of that name; the number of bodies when there is none.
inline std::size_t indexOf(const std::string& name, const std::vector<Body>& bodies) {
  const auto it =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  return static_cast<std::size_t>(it - bodies.begin());
}

}  // namespace rigid_body_sim
