#pragma once

#include "benchmark/peers.hpp"

namespace rigid_body_sim::peers {

struct Contender {
  std::string name;
  std::vector<Run> runs;
};

/// The attitude at the end, by the exact rotation or Taylor series in long double.
Quaternion4 truthOf(const Problem& problem);

/// auto, and every integrator of the catalogue.
std::vector<Contender> ourRuns(const Problem& problem);

}  // namespace rigid_body_sim::peers
