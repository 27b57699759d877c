#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>

namespace rigid_body_sim {

inline std::vector<std::string> namesOf(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  names.reserve(bodies.size());
  for (const Body& body : bodies) names.push_back(body.name);
  return names;
}

}  // namespace rigid_body_sim
