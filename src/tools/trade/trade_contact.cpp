#include "tools/trade/trade_contact.hpp"

#include <algorithm>
#include <optional>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/contact_bound.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kIntervals = 200;  // after each of which motions are compared
constexpr double kReferenceTolerance = 1e-10;

/// For a reference: what flies is solved to rounding, and nothing is tried before the run.
World toReference(World world, double tolerance) {
  world.solver.integrator = "auto";
  world.solver.tolerance = tolerance;
  world.solver.tolerance_stated = false;
  return world;
}

/// As if the scene stated this tolerance. Its own it states or not, as it is written: then that
/// is the run which its user gets.
World stating(World world, double tolerance) {
  world.solver.tolerance_stated |= tolerance != world.solver.tolerance;
  world.solver.tolerance = tolerance;
  return world;
}

/// In the given number of steps from instant to instant, none longer than the scene's.
std::vector<State> trackOf(World world, const State& initial, double duration, int divisions) {
  const double interval = duration / kIntervals;
  while (interval / divisions > world.solver.time_step) divisions *= 2;
  world.solver.time_step = interval / divisions;
  Simulation simulation(std::move(world), initial);
  std::vector<State> track{initial};
  for (int k = 0; k < kIntervals; ++k) {
    for (int i = 0; i < divisions; ++i) simulation.step();
    track.push_back(simulation.state());
  }
  return track;
}

/// [s] The last instant up to which two tracks stay within the budget of one another.
double agreeUntil(const World& world, const std::vector<State>& a, const std::vector<State>& b,
                  double error_budget) {
  const auto agree = [&](std::size_t instants) {
    const auto end = static_cast<std::ptrdiff_t>(instants) + 1;
    return errorsOf(world, {a.begin(), a.begin() + end}, {b.begin(), b.begin() + end}).bounded() <=
           error_budget;
  };
  std::size_t known = 0, unknown = a.size();
  while (unknown - known > 1) {  // errors are the worst so far, so that they only grow
    const std::size_t middle = (known + unknown) / 2;
    (agree(middle) ? known : unknown) = middle;
  }
  return b[known].t;
}

}  // namespace

Reference contactReference(const World& world, const State& initial, double duration,
                           double error_budget) {
  Reference reference;
  reference.duration = duration;
  reference.method = "auto at a tolerance of 1e-10";
  reference.check = "auto at 1e-9 and half the step, and at 1e-10 and a third of it,";
  reference.states = trackOf(toReference(world, kReferenceTolerance), initial, duration, 1);
  const auto check = [&](double tolerance, int divisions) {
    World other = toReference(world, tolerance);
    other.solver.time_step /= divisions;
    const std::vector<State> states = trackOf(std::move(other), initial, duration, divisions);
    reference.doubt = worst(reference.doubt, errorsOf(world, states, reference.states));
    reference.known_until =
        std::min(reference.known_until, agreeUntil(world, states, reference.states, error_budget));
  };
  check(10 * kReferenceTolerance, 2);
  check(kReferenceTolerance, 3);
  return reference;
}

void climbTolerances(const World& world, const Reference& reference, const std::string& integrator,
                     const std::function<void(const Setting&)>& measured,
                     const Patience& patience) {
  std::vector<double> tolerances{world.solver.tolerance};
  for (int digits = 1; digits <= 9; ++digits)
    tolerances.push_back(std::stod("1e-" + std::to_string(digits)));
  std::sort(tolerances.begin(), tolerances.end());
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  for (double tolerance : tolerances) {
    std::optional<Setting> setting = tryMeasuring(stating(world, tolerance), reference, integrator,
                                                  world.solver.time_step, patience);
    if (!setting) continue;
    setting->tolerance = tolerance;
    // groups form and part: only what all have evaluated counts
    setting->work = static_cast<double>(setting->force_evaluations);
    measured(*setting);
  }
}

}  // namespace rigid_body_sim
