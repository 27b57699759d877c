#include "ros/node/status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

using diagnostic_msgs::DiagnosticStatus;

double norm(const geometry_msgs::Vector3& v) { return fromVector3(v).norm(); }

/// Products of what is finite may not be: a body may move on whose energy is beyond 1.8e308 J.
bool areFinite(const SimStatus& status) {
  return std::isfinite(status.mechanical_energy) && fromVector3(status.momentum).allFinite() &&
         fromVector3(status.angular_momentum).allFinite();
}

void addMechanics(const Simulation& simulation, SimStatus& status) {
  const Totals totals = totalsOf(simulation.world(), simulation.state());
  status.mechanical_energy = totals.energy;
  status.momentum = toVector3(totals.momentum);
  status.angular_momentum = toVector3(totals.angular_momentum);
  status.work = simulation.exchanged().energy;
  const Totals balance = simulation.balance();
  status.energy_balance = balance.energy;
  status.momentum_balance = toVector3(balance.momentum);
  status.angular_momentum_balance = toVector3(balance.angular_momentum);
}

void addContacts(const Simulation& simulation, SimStatus& status) {
  for (const ContactPoint& contact : contactsOf(simulation.world(), simulation.state())) {
    ++status.contacts;
    status.greatest_penetration = std::max(status.greatest_penetration, contact.penetration);
  }
}

}  // namespace

void addFigures(const Simulation& simulation, SimStatus& status) {
  const World& world = simulation.world();
  status.time = simulation.time();
  status.steps = static_cast<std::uint64_t>(simulation.steps());
  status.active_wrenches = static_cast<std::uint32_t>(simulation.wrenchCount());
  addMechanics(simulation, status);
  addContacts(simulation, status);
  status.saturations = static_cast<std::uint64_t>(simulation.saturations());
  status.tolerance_holds = holdsTolerance(simulation);
  status.attitude_error = status.position_error = std::numeric_limits<double>::quiet_NaN();
  if (world.solver.integrator == "auto") {
    status.attitude_error = simulation.errorEstimate().attitude;
    status.position_error = simulation.errorEstimate().position;
  }
  status.most_parts = static_cast<std::uint32_t>(simulation.maxSubsteps());
}

bool isWithinTolerance(const ErrorEstimate& error, double time, const SolverOptions& solver) {
  return solver.integrator != "auto" || time > solver.horizon || error.attitude <= solver.tolerance;
}

bool holdsByTrials(const std::vector<MotionPlan>& plans) {
  return std::all_of(plans.begin(), plans.end(), [](const MotionPlan& plan) { return plan.holds; });
}

bool holdsTolerance(const Simulation& simulation) {
  return isWithinTolerance(simulation.errorEstimate(),
                           simulation.time() - simulation.horizonBegins(),
                           simulation.world().solver) &&
         holdsByTrials(simulation.plans()) && simulation.time() < simulation.contactTrial().lost_at;
}

void describe(const Health& health, diagnostic_updater::DiagnosticStatusWrapper& diagnostic) {
  const SimStatus& status = health.status;
  diagnostic.summary(DiagnosticStatus::OK, status.paused ? "paused" : "running");
  if (health.new_overruns > 0)
    diagnostic.mergeSummaryf(DiagnosticStatus::WARN, "%llu steps began late",
                             static_cast<unsigned long long>(health.new_overruns));
  if (status.most_parts > 1)
    diagnostic.mergeSummaryf(DiagnosticStatus::WARN, "steps are taken in up to %u substeps",
                             status.most_parts);
  if (!health.holds_tolerance)
    diagnostic.mergeSummary(DiagnosticStatus::WARN, "the scene's tolerance is not held");
  if (!areFinite(status))
    diagnostic.mergeSummary(
        DiagnosticStatus::WARN,
        "energy or momentum is beyond 1.8e308, and their balances are not known");
  if (!health.divergence.empty())
    diagnostic.summary(DiagnosticStatus::ERROR, "diverged: " + health.divergence);

  diagnostic.add("simulation time [s]", status.time);
  diagnostic.add("steps", status.steps);
  diagnostic.add("real-time factor reached", status.real_time_factor);
  diagnostic.add("real-time factor requested", status.requested_real_time_factor);
  diagnostic.add("overruns", status.overruns);
  diagnostic.add("inputs refused", status.refused);
  diagnostic.add("wrenches that act or are to come", status.active_wrenches);
  diagnostic.add("estimated attitude error [rad]", status.attitude_error);
  diagnostic.add("estimated position error [m]", status.position_error);
  diagnostic.add("most substeps of a step", status.most_parts);
  diagnostic.add("places that touch", status.contacts);
  diagnostic.add("greatest penetration [m]", status.greatest_penetration);
  diagnostic.add("commands held at a limit", status.saturations);
  diagnostic.add("energy [J]", status.mechanical_energy);
  diagnostic.add("energy balance [J]", status.energy_balance);
  diagnostic.add("momentum balance [kg m/s]", norm(status.momentum_balance));
  diagnostic.add("angular momentum balance [kg m^2/s]", norm(status.angular_momentum_balance));
}

}  // namespace rigid_body_sim
