#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/compare_runs/recorded_motion.hpp"

namespace rigid_body_sim {

/// By how much the motions of a body differ, the greatest of the instants that both runs hold.
struct MotionDifference {
  std::string body;
  std::size_t instants = 0;  ///< that both hold
  std::size_t alone = 0;     ///< that one of the two holds
  std::size_t several = 0;   ///< at which one of the runs holds several motions
  bool same_bits = true;
  double position = 0;          ///< [m]
  double attitude = 0;          ///< [rad]
  double velocity = 0;          ///< [m/s]
  double angular_velocity = 0;  ///< [rad/s]
  std::int64_t first = 0;       ///< [ns] the first instant at which the bits differ, if any do

  bool isWithin(double tolerance) const;

  /// Whether the numbers that differ mean the same motion.
  bool isOfBitsAlone() const;
};

/// Of every body that both runs hold. Of an instant at which a run holds several motions the two
/// count that are nearest to each other: which of them the other run shows is of no meaning, and
/// what follows shows the last. Throws std::runtime_error, one line, where there is none, and
/// for a body without an instant that both hold.
std::vector<MotionDifference> differencesOf(const RecordedMotion& a, const RecordedMotion& b);

/// The bodies that one of the runs holds and the other does not.
std::vector<std::string> bodiesOfOne(const RecordedMotion& a, const RecordedMotion& b);

/// A line.
std::string text(const MotionDifference& difference);

}  // namespace rigid_body_sim
