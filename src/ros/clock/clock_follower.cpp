#include "ros/clock/clock_follower.hpp"

#include <utility>

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kClockQueue = 100;

}  // namespace

ClockFollower::ClockFollower(ros::NodeHandle nh)
    : subscriber_(nh.subscribe("/clock", kClockQueue, &ClockFollower::hear, this,
                               ros::TransportHints().tcpNoDelay())) {}

bool ClockFollower::takeSetBack() { return std::exchange(set_back_, false); }

void ClockFollower::hear(const rosgraph_msgs::Clock& message) {
  if (message.clock < now_) set_back_ = true;
  before_ = set_back_ ? ros::Time() : now_;
  heard_ = true;
  now_ = message.clock;
}

}  // namespace rigid_body_sim
