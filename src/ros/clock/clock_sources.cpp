#include "ros/clock/clock_sources.hpp"

#include <utility>

#include <ros/console.h>

namespace rigid_body_sim {

void ClockSources::note(const ClockEvent& event, const ros::Subscriber& subscriber) {
  const std::string& publisher = event.getPublisherName();
  if (publisher == last_) return;
  const std::string before = std::exchange(last_, publisher);
  // one that has ended may be followed by another
  if (before.empty() || subscriber.getNumPublishers() < 2) return;
  if (std::exchange(warned_, true)) return;
  ROS_WARN(
      "/clock is published by two nodes, %s and %s: time jumps between theirs; stop one of them",
      before.c_str(), publisher.c_str());
}

}  // namespace rigid_body_sim
