#pragma once

#include <chrono>
#include <string>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include "ros/messages/conversions.hpp"
#include "ros/node/status.hpp"
#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// Reports once a second of wall time, paused or not, how the simulation fares: on ~status and
/// /diagnostics. Without subscribers nothing is computed; with them, the balance, and errors with
/// auto, are tracked.
class Monitor {
 public:
  using Clock = std::chrono::steady_clock;

  /// Simulation and origin are referred to, not copied.
  Monitor(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
          const std::string& world_frame, Simulation& simulation, const TimeOrigin& origin);

  bool isDue(Clock::time_point now) const { return now >= next_report_; }

  /// What is to be filled in of health is said there.
  void report(Health health, Clock::time_point now);

  /// Tracks balances and estimates from now on where somebody has subscribed to them since the last
  /// report; they end at a report without subscribers.
  void beginWhereAskedFor();

  /// Simulation time has been set.
  void restart(Clock::time_point now);

 private:
  bool hasSubscribers() const;
  void track(bool wanted);
  void warnOfLostTolerance();

  std::string world_frame_;
  Simulation& simulation_;
  const TimeOrigin& origin_;
  Clock::time_point next_report_;
  Clock::time_point last_report_;
  double last_t_ = 0;
  std::uint64_t last_overruns_ = 0;
  bool tracked_ = false;
  bool has_warned_ = false;  // that the tolerance is not held
  Health health_;            // of the last report
  Topic<SimStatus> status_;
  Topic<diagnostic_msgs::DiagnosticArray>
      diagnostics_;  // the updater's topic, to know whether it has subscribers
  diagnostic_updater::Updater updater_;
};

}  // namespace rigid_body_sim
