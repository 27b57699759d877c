#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

/// nameList of the bodies.
inline std::string namesOf(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  names.reserve(bodies.size());
  for (const Body& body : bodies) names.push_back(body.name);
  return nameList(names);
}

}  // namespace rigid_body_sim
