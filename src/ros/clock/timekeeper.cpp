#include "ros/clock/timekeeper.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <ros/console.h>
#include <ros/init.h>

namespace rigid_body_sim {
namespace {

TimeOrigin wallOrigin() {
  const ros::WallTime now = ros::WallTime::now();
  return {ros::Time(now.sec, now.nsec)};
}

}  // namespace

Timekeeper::Timekeeper(const NodeOptions& options, const ros::NodeHandle& nh,
                       ros::CallbackQueue& queue)
    : options_(options),
      pacer_(options.follow_clock ? 0 : options.real_time_factor),
      clock_(options.follow_clock ? std::make_unique<ClockFollower>(nh) : nullptr),
      own_clock_(options.publish_clock ? subscribeToClock(nh) : ros::Subscriber()),
      origin_(findStart(queue)) {}

/// Its own messages, and those of a node that should not publish it.
ros::Subscriber Timekeeper::subscribeToClock(ros::NodeHandle nh) {
  constexpr std::uint32_t kClockQueue = 10;
  const boost::function<void(const ClockEvent&)> note = [this](const ClockEvent& event) {
    sources_.note(event, own_clock_);
  };
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const ClockEvent&>("/clock", kClockQueue, note);
  return nh.subscribe(options);
}

TimeOrigin Timekeeper::findStart(ros::CallbackQueue& queue) const {
  if (options_.publish_clock) return {ros::Time()};
  if (options_.start_time) return {ros::Time(*options_.start_time)};
  if (clock_) {
    waitForClock(queue);
    return {clock_->now()};
  }
  return wallOrigin();
}

void Timekeeper::startRun() {
  if (!options_.publish_clock && !options_.start_time && !clock_) origin_ = wallOrigin();
}

void Timekeeper::waitForClock(ros::CallbackQueue& queue) const {
  constexpr std::chrono::seconds kSilence(1);
  const Pacer::Clock::time_point begin = Pacer::Clock::now();
  bool warned = false;
  while (!clock_->isReceived()) {
    if (!ros::ok()) throw std::runtime_error("shut down before /clock was received");
    queue.callAvailable(ros::WallDuration(kLongestWait));
    if (warned || Pacer::Clock::now() - begin < kSilence) continue;
    warned = true;
    ROS_WARN(
        "waiting for /clock: /use_sim_time is true, ~publish_clock false, and no node "
        "publishes it; topics and services start once it is received");
  }
}

void Timekeeper::restart(double t) { pacer_.restart(t, Pacer::Clock::now()); }

std::string Timekeeper::setRealTimeFactor(double factor, double next) {
  if (!(factor >= 0) || !std::isfinite(factor)) {
    std::ostringstream fault;
    fault << "factor must be a finite number >= 0, got " << factor;
    return fault.str();
  }
  if (clock_) return "this node follows the /clock of another node, which sets the pace";
  options_.real_time_factor = factor;
  pacer_.setFactor(factor, next, Pacer::Clock::now());
  return "";
}

void Timekeeper::jumpTo(double t, const ros::Time& last_stamp, double h) {
  if (options_.publish_clock) return;
  origin_.start = last_stamp + ros::Duration(h) - ros::Duration(t);
}

std::string Timekeeper::faultOfJump(double t, const ros::Time& last_stamp) const {
  std::ostringstream fault;
  if (!origin_.hasStamp(t)) {
    fault << "the state is at " << t << " s of its run, for which ROS time has no stamp";
    return fault.str();
  }
  if (options_.publish_clock || last_stamp.toSec() > t) return "";
  fault << "the state is at " << t << " s of its run, later than the clock that this node follows, "
        << last_stamp;
  return fault.str();
}

double Timekeeper::untilDue(double t) const {
  if (clock_) return isAhead(t) ? kLongestWait : 0;
  return std::min(pacer_.wait(t, Pacer::Clock::now()), kLongestWait);
}

bool Timekeeper::isAhead(double t) const {
  return clock_ && (!origin_.hasStamp(t) || origin_.stamp(t) > clock_->now());
}

void Timekeeper::begin(double t, double h) {
  if (!clock_) return pacer_.begin(t, h, Pacer::Clock::now());
  if (origin_.stamp(t) <= clock_->before()) ++left_behind_;
}

void Timekeeper::dropBacklog(double t) {
  if (!clock_) pacer_.dropBacklog(t, Pacer::Clock::now());
}

bool Timekeeper::takeSetBack() {
  if (!clock_ || !clock_->takeSetBack()) return false;
  if (!options_.start_time) origin_.start = clock_->now();
  return true;
}

}  // namespace rigid_body_sim
