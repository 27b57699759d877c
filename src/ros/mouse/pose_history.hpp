#pragma once

#include <iterator>
#include <map>

#include <ros/time.h>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Where a body was during the last ten seconds, as tf keeps it, to a millisecond: a viewer speaks
/// of a frame as it was at a stamp that it has received.
class PoseHistory {
 public:
  /// Stamps increase.
  void add(const ros::Time& stamp, const Isometry3d& X_WB) {
    if (!poses_.empty() && stamp < poses_.rbegin()->first + ros::Duration(5e-4)) return;
    poses_[stamp] = X_WB;
    while (poses_.begin()->first + ros::Duration(10) < stamp) poses_.erase(poses_.begin());
  }

  /// The pose at the stamp or before it; the oldest for what lies before, the newest for stamp
  /// zero. Needs one pose at least.
  const Isometry3d& at(const ros::Time& stamp) const {
    auto after = stamp.isZero() ? poses_.end() : poses_.upper_bound(stamp);
    return after == poses_.begin() ? after->second : std::prev(after)->second;
  }

 private:
  std::map<ros::Time, Isometry3d> poses_;
};

}  // namespace rigid_body_sim
