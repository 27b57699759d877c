#pragma once

#include <chrono>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include "ros/messages/conversions.hpp"
#include "ros/node/status.hpp"

namespace rigid_body_sim {

/// Tells once a second of wall time, paused or not, how the simulation fares: on ~status and
/// /diagnostics. Without subscribers nothing is computed.
class Monitor {
 public:
  using Clock = std::chrono::steady_clock;

  Monitor(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& world_frame,
          const TimeOrigin& origin);

  bool isDue(Clock::time_point now) const { return now >= next_report_; }

  /// Whether somebody listens.
  bool isHeard() const;

  void report(const Simulation& simulation, const RunFigures& figures, Clock::time_point now);

  /// Simulation time has been set to t [s].
  void restart(double t, Clock::time_point now);

 private:
  std::string world_frame_;
  const TimeOrigin& origin_;
  Clock::time_point next_report_;
  Clock::time_point last_report_;
  double last_t_ = 0;
  std::uint64_t last_overruns_ = 0;
  Health health_;
  ros::Publisher status_;
  ros::Publisher diagnostics_;  // the updater's topic, to know whether somebody listens
  diagnostic_updater::Updater updater_;
};

}  // namespace rigid_body_sim
