#include "ros/node/monitor.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::chrono::seconds kPeriod(1);
constexpr std::uint32_t kMonitorQueue = 10;

}  // namespace

Monitor::Monitor(ros::NodeHandle nh, ros::NodeHandle private_nh, const std::string& world_frame,
                 const TimeOrigin& origin)
    : world_frame_(world_frame),
      origin_(origin),
      last_report_(Clock::now()),
      status_(private_nh.advertise<SimStatus>("status", kMonitorQueue)),
      diagnostics_(nh.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", kMonitorQueue)),
      updater_(nh, private_nh) {
  updater_.setHardwareID("none");
  updater_.add("simulation", [this](diagnostic_updater::DiagnosticStatusWrapper& diagnostic) {
    describe(health_, diagnostic);
  });
}

bool Monitor::isHeard() const {
  return diagnostics_.getNumSubscribers() > 0 || status_.getNumSubscribers() > 0;
}

void Monitor::report(const Simulation& simulation, const RunFigures& figures,
                     Clock::time_point now) {
  next_report_ = now + kPeriod;
  const std::chrono::duration<double> elapsed = now - last_report_;
  const double advanced = simulation.time() - last_t_;
  restart(simulation.time(), now);
  const auto overruns = static_cast<std::uint64_t>(figures.overruns);
  health_.new_overruns = overruns - last_overruns_;
  last_overruns_ = overruns;
  if (!isHeard()) return;

  health_.status = toSimStatus(simulation, figures);
  health_.status.header.frame_id = world_frame_;
  health_.status.header.stamp = origin_.stamp(simulation.time());
  if (elapsed.count() > 0) health_.status.real_time_factor = advanced / elapsed.count();
  health_.holds_tolerance = holdsTolerance(simulation);
  health_.divergence = figures.divergence;
  status_.publish(health_.status);
  // at the monitor's pace: the updater's own follows ROS time, which stands still while paused
  if (diagnostics_.getNumSubscribers() > 0) updater_.force_update();
}

void Monitor::restart(double t, Clock::time_point now) {
  last_t_ = t;
  last_report_ = now;
}

}  // namespace rigid_body_sim
