#include "ros/node/monitor.hpp"

#include <utility>

#include <ros/console.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::chrono::seconds kMonitorPeriod(1);
constexpr std::uint32_t kMonitorQueue = 10;

}  // namespace

Monitor::Monitor(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                 const std::string& world_frame, Simulation& simulation, const TimeOrigin& origin)
    : world_frame_(world_frame),
      simulation_(simulation),
      origin_(origin),
      last_report_(Clock::now()),
      status_(RosTransport(private_nh, kMonitorQueue).open<SimStatus>("~status", false)),
      diagnostics_(RosTransport(nh, kMonitorQueue)
                       .open<diagnostic_msgs::DiagnosticArray>("/diagnostics", false)),
      updater_(nh, private_nh) {
  updater_.setHardwareID("none");
  updater_.add("simulation", [this](diagnostic_updater::DiagnosticStatusWrapper& diagnostic) {
    describe(health_, diagnostic);
  });
}

bool Monitor::hasSubscribers() const {
  return diagnostics_.hasSubscribers() || status_.hasSubscribers();
}

void Monitor::track(bool wanted) {
  if (wanted == tracked_) return;
  tracked_ = wanted;
  if (!wanted) return simulation_.stopTracking();
  simulation_.trackBalance();
  if (simulation_.world().solver.integrator == "auto") simulation_.trackError();
}

void Monitor::warnOfLostTolerance() {
  std::string warning = describePromise(simulation_);
  if (warning.empty()) warning = describeMagnification(simulation_);
  if (!warning.empty() && !has_warned_) ROS_WARN_STREAM(warning);
  has_warned_ = !warning.empty();
}

void Monitor::beginWhereAskedFor() {
  if (!tracked_ && hasSubscribers()) track(true);
}

void Monitor::report(Health health, Clock::time_point now) {
  track(hasSubscribers());
  next_report_ = now + kMonitorPeriod;
  const std::chrono::duration<double> elapsed = now - last_report_;
  const double advanced = simulation_.time() - last_t_;
  restart(now);
  health.new_overruns = health.status.overruns - last_overruns_;
  last_overruns_ = health.status.overruns;
  warnOfLostTolerance();
  if (!hasSubscribers()) return;

  addFigures(simulation_, health.status);
  health.status.header.frame_id = world_frame_;
  health.status.header.stamp = origin_.stamp(simulation_.time());
  if (elapsed.count() > 0) health.status.real_time_factor = advanced / elapsed.count();
  health.holds_tolerance = health.status.tolerance_holds;
  health_ = std::move(health);
  status_.publish(health_.status, health_.status.header.stamp);
  // at the monitor's pace: the updater's own follows ROS time, which stands still while paused
  if (diagnostics_.hasSubscribers()) updater_.force_update();
}

void Monitor::restart(Clock::time_point now) {
  last_t_ = simulation_.time();
  last_report_ = now;
}

}  // namespace rigid_body_sim
