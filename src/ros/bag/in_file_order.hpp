#pragma once

#include <functional>

namespace rosbag {
class Bag;
class MessageInstance;
}  // namespace rosbag

namespace rigid_body_sim {

/// The messages of a bag in the order in which they were written. A view of rosbag has them in the
/// order of the times at which they came, which mixes the runs of a bag that was recorded under a
/// simulation clock: a reset sets that back.
void inFileOrder(const rosbag::Bag& bag,
                 const std::function<void(const rosbag::MessageInstance&)>& take);

}  // namespace rigid_body_sim
