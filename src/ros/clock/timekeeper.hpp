#pragma once

#include <memory>
#include <string>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include "ros/clock/clock_follower.hpp"
#include "ros/clock/pacer.hpp"
#include "ros/messages/conversions.hpp"
#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// Which stamps the steps bear, and when they are due: by the wall as the Pacer ties it to
/// simulation time, or by the clock of another node, as soon as that has reached the stamp. Such a
/// clock is never passed; a step that it has left behind is taken at once, and none is dropped.
class Timekeeper {
 public:
  /// Waits for a clock that is followed from where it is first received, and says so after a
  /// second: before, there is no stamp to give and no start to count from. The queue, which
  /// outlives this, is that of the handle. Throws std::runtime_error when ROS shuts down while it
  /// waits.
  Timekeeper(const NodeOptions& options, const ros::NodeHandle& nh, ros::CallbackQueue& queue);

  const TimeOrigin& origin() const { return origin_; }

  /// The run begins. Where stamps are those of the wall, time zero is now: thousands of topics take
  /// seconds to be registered, which the stamps would lag behind for ever.
  void startRun();

  /// Ties the wall to simulation time t [s].
  void restart(double t);

  /// Simulated over wall time, as it is set; 0: as fast as possible.
  double realTimeFactor() const { return options_.real_time_factor; }

  /// Sets it before the step that reaches the simulation time next [s]; time runs on from where it
  /// is. Returns why it is refused, and stays what it was; empty if it is not.
  std::string setRealTimeFactor(double factor, double next);

  /// Simulation time has become t [s], whatever it was. Where the stamps do not count from zero,
  /// that of the state there follows the given one by a time step of h [s].
  void jumpTo(double t, const ros::Time& last_stamp, double h);

  /// Why it cannot; empty if it can.
  std::string faultOfJump(double t, const ros::Time& last_stamp) const;

  /// Wall time [s], below the longest wait, until it is worth asking again whether the step that
  /// reaches t [s] is due; not above 0: it is.
  double untilDue(double t) const;

  /// Whether the step that reaches t [s] was due at that time, by the wall.
  bool wasDue(double t, Pacer::Clock::time_point then) const { return pacer_.wait(t, then) <= 0; }

  bool followsClock() const { return clock_ != nullptr; }

  /// Whether t [s] lies ahead of a clock that is followed.
  bool isAhead(double t) const;

  /// The step from t − h to t begins now. Late is one that begins later than by its own length, or,
  /// with a clock that is followed, after the clock has moved on since it was due.
  void begin(double t, double h);

  /// An instant t [s] within a step is published now.
  void dropBacklog(double t);

  /// Whether a clock that is followed has been set back since this was asked last, and simulation
  /// time with it: to its start, which lies where the clock is now unless start_time says where.
  bool takeSetBack();

  std::int64_t overruns() const { return pacer_.overruns() + left_behind_; }

  /// Longest wait for a callback [s]: how soon a shutdown is seen.
  static constexpr double kLongestWait = 0.05;

 private:
  ros::Subscriber subscribeToClock(ros::NodeHandle nh);
  TimeOrigin findStart(ros::CallbackQueue& queue) const;
  void waitForClock(ros::CallbackQueue& queue) const;

  NodeOptions options_;
  Pacer pacer_;
  std::unique_ptr<ClockFollower> clock_;  // null unless it is another's
  ClockSources sources_;
  ros::Subscriber own_clock_;  // with publish_clock
  TimeOrigin origin_;
  std::int64_t left_behind_ = 0;  // steps, by a clock that is followed
};

}  // namespace rigid_body_sim
