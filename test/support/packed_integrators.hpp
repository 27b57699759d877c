#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim::test {

/// The integrators that step bodies that do not act on one another in packs.
inline const std::vector<std::string>& packedIntegrators() {
  static const std::vector<std::string> names{"semi_implicit_euler", "strang", "magnus4", "rk4"};
  return names;
}

}  // namespace rigid_body_sim::test
