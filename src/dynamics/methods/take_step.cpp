#include "dynamics/methods/take_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kRounding = 1e-12;  // of an estimate

/// A step in equal substeps. Returns the greatest estimate of one; infinity, and leaves the step
/// unfinished, where one cannot be followed.
double stepInSubsteps(const Method& method, const System& system, double h, int substeps,
                      SystemState& states, Workspace& workspace) {
  double worst = 0;
  for (int done = 0; done < substeps; ++done) {
    method.step(system, h / substeps, states, workspace);
    if (std::isinf(workspace.error)) return workspace.error;
    worst = std::max(worst, workspace.error);
  }
  return worst;
}

/// A step in substeps that are short only where the estimate asks for it: around the instant at
/// which a force jumps, or nearly so. Returns whether that worked; where not, the states are left
/// anywhere.
bool stepAroundJumps(const Method& method, const System& system, double h, SystemState& states,
                     Workspace& workspace) {
  const StepBound of_step = workspace.step_bound;
  constexpr int kMaxTries = 4096;
  constexpr double kShortest = 0x1p-50;
  // where a force jumps, an estimate of high order says some ten times too little
  const double bound = std::max(0.01 * of_step.error, 1e-14);
  double done = 0, share = 1;  // of h; powers of two and their sums, which are exact
  SystemState start = states;
  for (int tries = 0; tries < kMaxTries; ++tries) {
    // an error of momentum lasts beyond its substep, however short that is
    workspace.step_bound.idle = of_step.idle * share * share;
    method.step(system, share * h, states, workspace);
    workspace.step_bound = of_step;
    if (workspace.error <= bound || (share <= kShortest && workspace.error <= kRounding)) {
      done += share;
      if (done == 1) return true;
      start = states;
      while (std::fmod(done, 2 * share) == 0) share *= 2;
    } else if (share > kShortest) {
      states = start;
      share /= 2;
    } else {
      return false;
    }
  }
  return false;
}

}  // namespace

void takeControlledStep(const Method& method, const System& system, double h, SystemState& states,
                        Workspace& workspace) {
  constexpr int kMaxSubsteps = 1 << 12;
  constexpr double kGain = 4;  // by halving the substeps: far below the 2⁸ of the order
  const SystemState start = states;
  double last_error = std::numeric_limits<double>::infinity();
  int failures = 0;  // to gain, one after the other
  for (int substeps = 1; substeps <= kMaxSubsteps; substeps *= 2) {
    const double error = stepInSubsteps(method, system, h, substeps, states, workspace);
    const bool gained = substeps == 1 || error < last_error / kGain;
    failures = gained ? 0 : failures + 1;
    if (error <= workspace.step_bound.error || (failures > 0 && error <= kRounding)) {
      if (failures > 0) ++workspace.rough_steps;
      return;
    }
    // once is not enough: the gain depends on where in a substep a force jumps
    if (failures == 3 || (substeps == kMaxSubsteps && std::isfinite(error))) {
      ++workspace.rough_steps;
      const SystemState in_equal_substeps = states;
      states = start;
      if (stepAroundJumps(method, system, h, states, workspace)) return;
      states = in_equal_substeps;
      if (std::isfinite(error)) return;
    }
    last_error = error;
    states = start;
  }
  std::ostringstream reason;
  reason << method.name << " cannot follow the motion, even in " << kMaxSubsteps << " substeps";
  throw StepTooLong(reason.str());
}

}  // namespace rigid_body_sim
