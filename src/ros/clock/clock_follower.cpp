#include "ros/clock/clock_follower.hpp"

#include <utility>

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kClockQueue = 100;

}  // namespace

ClockFollower::ClockFollower(ros::NodeHandle nh)
    : subscriber_(nh.subscribe("/clock", kClockQueue, &ClockFollower::receive, this,
                               ros::TransportHints().tcpNoDelay())) {}

bool ClockFollower::takeSetBack() { return std::exchange(set_back_, false); }

void ClockFollower::receive(const ClockEvent& event) {
  sources_.note(event, subscriber_);
  const ros::Time& clock = event.getMessage()->clock;
  received_ = true;
  if (clock == now_) return;  // it stands still
  if (clock < now_) set_back_ = true;
  before_ = set_back_ ? ros::Time() : now_;
  now_ = clock;
}

}  // namespace rigid_body_sim
