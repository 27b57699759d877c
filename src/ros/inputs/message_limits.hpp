#pragma once

#include <cstdint>

namespace rigid_body_sim {

/// Messages of a topic that may wait for the next step: a tenth of a second at 10 000 a second.
constexpr std::uint32_t kMessageQueue = 1000;

/// [s] A controller commands moments ahead of simulation time; what is stamped further ahead is of
/// another clock.
constexpr double kFarthestCommand = 3600;

}  // namespace rigid_body_sim
