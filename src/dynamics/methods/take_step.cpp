#include "dynamics/methods/take_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "dynamics/step_too_long.hpp"

namespace rigid_body_sim {
namespace {

/// A step in equal parts. Returns the greatest estimate of a part; infinity, and leaves the step
/// unfinished, where a part cannot be followed.
double stepInParts(const Method& method, const System& system, double h, int parts,
                   SystemState& states, Workspace& workspace) {
  double worst = 0;
  for (int done = 0; done < parts; ++done) {
    method.step(system, h / parts, states, workspace);
    if (std::isinf(workspace.error)) return workspace.error;
    worst = std::max(worst, workspace.error);
  }
  return worst;
}

}  // namespace

void takeControlledStep(const Method& method, const System& system, double h, SystemState& states,
                        Workspace& workspace) {
  constexpr int kMaxParts = 1 << 12;
  constexpr double kGain = 4;  // by halving the parts: far below the 2⁸ of the order
  constexpr double kRounding = 1e-12;
  const SystemState start = states;
  double last_error = std::numeric_limits<double>::infinity();
  int failures = 0;  // to gain, one after the other
  for (int parts = 1; parts <= kMaxParts; parts *= 2) {
    const double error = stepInParts(method, system, h, parts, states, workspace);
    failures = error <= last_error / kGain ? 0 : failures + 1;
    // once is not enough: where a force has a kink, as |v| v at rest, the gain depends on where in
    // a part the kink lies
    const bool stuck = failures > 0 && (failures > 2 || error <= kRounding);
    if (error <= workspace.step_bound.error ||
        (std::isfinite(error) && (stuck || parts == kMaxParts)))
      return;
    last_error = error;
    states = start;
  }
  std::ostringstream reason;
  reason << method.name << " cannot follow the motion, even in " << kMaxParts << " substeps";
  throw StepTooLong(reason.str());
}

}  // namespace rigid_body_sim
