#pragma once

#include <vector>

#include "benchmark/peers.hpp"

namespace rigid_body_sim::peers {

struct Case {
  const char* name;
  Problem (*make)();  ///< with its truth
};

const std::vector<Case>& cases();

}  // namespace rigid_body_sim::peers
