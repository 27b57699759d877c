#pragma once

#include <cstdint>
#include <vector>

#include <visualization_msgs/MenuEntry.h>

namespace rigid_body_sim {

/// What the menu of a handle offers, by the ids of its entries.
enum class MenuChoice : std::uint32_t {
  kPause = 1,
  kResume,
  kOneStep,
  kTenSteps,
  kSlower,
  kFaster,
  kReset,
  kClearWrenches,
  kFollow,
  kStopFollowing
};

/// The menu that viewers show at a right click on a handle.
std::vector<visualization_msgs::MenuEntry> menuEntries();

/// Half or twice as fast; from as fast as possible (0) down to real time, and beyond 1024 times
/// real time up to as fast as possible. Not slower than 1/1024.
double slowerFactor(double real_time_factor);
double fasterFactor(double real_time_factor);

}  // namespace rigid_body_sim
