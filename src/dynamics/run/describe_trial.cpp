#include "dynamics/run/describe_trial.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <rigid_body_sim/dynamics/contact_point.hpp>

#include "dynamics/run/contact_bound.hpp"

namespace rigid_body_sim {
namespace {

/// What auto's trial of a whole run was for: contact, or the first law of another kind that begins
/// and ceases to act; empty where there is none.
std::string triedLaws(const World& world) {
  if (hasContact(world)) return "contact";
  const auto law = std::find_if(world.laws.begin(), world.laws.end(),
                                [](const auto& each) { return each->isOneSided(); });
  return law == world.laws.end() ? "" : (*law)->name();
}

}  // namespace

std::string describeTrial(const Simulation& simulation) {
  const std::string subject = triedLaws(simulation.world());
  if (subject.empty()) return "";
  const SolverOptions& solver = simulation.world().solver;
  const std::string cause =
      hasContact(simulation.world()) ? "impacts" : "forces that begin and end";
  const ContactTrial trial = simulation.contactTrial();
  std::ostringstream text;
  if (std::isfinite(trial.lost_at)) {
    text << subject << ": a trial shows that tolerance " << solver.tolerance
         << " is not certain to be held from " << trial.lost_at << " s on: " << cause
         << " magnify errors, and "
         << (trial.step_bound <= kLeastContactBound ? "steps cannot be tighter"
                                                    : "tighter steps take longer than a trial");
    return text.str();
  }
  if (trial.is_made && !trial.compares) {
    text << subject << ": whether tolerance " << solver.tolerance
         << " holds is not known: the work of a trial ended before there was anything to compare; "
            "try a shorter time_step or horizon, or a lower stiffness";
    return text.str();
  }
  const double tighter = contactStepBound(solver.tolerance) / trial.step_bound;
  if (tighter > 1.5)
    text << subject << ": errors of a step are kept " << tighter << " times smaller than tolerance "
         << solver.tolerance << " asks for at first, because " << cause << " magnify them";
  const double horizon_ends = simulation.horizonBegins() + solver.horizon;
  const bool cut_short = trial.tried_until > simulation.time() && trial.tried_until < horizon_ends;
  if (cut_short)
    text << (tighter > 1.5 ? "; " : subject + ": ")
         << "a trial, whose work is bounded, shows tolerance " << solver.tolerance
         << " to hold up to " << trial.tried_until << " s of " << horizon_ends << " s";
  return text.str();
}

}  // namespace rigid_body_sim
