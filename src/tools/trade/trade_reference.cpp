#include "tools/trade/trade_reference.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/methods/catalogue.hpp"
#include "tools/trade/trade_solved.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kInstants = 200;  // at which motions are compared
// bound on the work of one run, in steps of strang with one body: seconds
constexpr double kMaxReferenceWork = 1e7;

using Track = std::vector<State>;

World withSolver(World world, const std::string& integrator, double time_step) {
  world.solver.integrator = integrator;
  world.solver.time_step = time_step;
  return world;
}

bool supports(const World& world, const State& initial, const std::string& integrator) {
  try {
    const Simulation made(withSolver(world, integrator, world.solver.time_step), initial);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

struct Run {
  Track track;
  std::int64_t evaluations;
};

/// A run in the given number of steps (divisions) from instant to instant. Throws
/// SimulationDiverged, also where steps have to be divided so much that it would not end.
Run runOf(const World& world, const State& initial, const std::string& integrator, double duration,
          int divisions) {
  Simulation simulation(withSolver(world, integrator, duration / kInstants / divisions), initial);
  const Method& method = methodNamed(integrator);
  const double most_evaluations = 2 * kMaxReferenceWork / method.cost * method.evaluations;
  Track track{initial};
  for (int k = 0; k < kInstants; ++k) {
    for (int i = 0; i < divisions; ++i) {
      simulation.step();
      if (static_cast<double>(simulation.evaluations()) > most_evaluations)
        throw SimulationDiverged(simulation.time(), world.bodies.front().name,
                                 "what moves here is too fast for a reference to be computed");
    }
    track.push_back(simulation.state());
  }
  return {std::move(track), simulation.evaluations()};
}

/// The run of an integrator that comes closest to the truth or, without one, to its own run in
/// steps twice as long.
Track refined(const World& world, const State& initial, const std::string& integrator,
              double duration, const Track* truth) {
  constexpr double kConverging = 1e-3;  // from here on, no gain means that rounding dominates
  constexpr double kGain = 1.5;
  const double work =
      methodNamed(integrator).cost * kInstants * static_cast<double>(world.bodies.size());
  Track best;
  Run last{{}, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int divisions = 1; divisions == 1 || divisions * work < kMaxReferenceWork; divisions *= 2) {
    Run run;
    try {
      run = runOf(world, initial, integrator, duration, divisions);
    } catch (const SimulationDiverged&) {
      if (2 * divisions * work >= kMaxReferenceWork && best.empty()) throw;
      continue;
    }
    // an integrator that divides long steps by itself would only agree with itself
    const bool shorter =
        static_cast<double>(run.evaluations) > 1.9 * static_cast<double>(last.evaluations);
    if (best.empty()) best = run.track;
    const Track* other = truth ? truth : last.track.empty() ? nullptr : &last.track;
    if (shorter && other) {
      const double gap = errorsOf(world, run.track, *other).bounded();
      const double before = least;
      if (gap < least) best = run.track;
      least = std::min(least, gap);
      if (before < kConverging && gap >= before / kGain) break;
    }
    last = std::move(run);
  }
  return best;
}

bool hasPivots(const World& world) {
  return std::any_of(world.bodies.begin(), world.bodies.end(),
                     [](const Body& body) { return body.pivoted; });
}

}  // namespace

Reference computeReference(const World& world, const State& initial, double duration) {
  Reference reference;
  reference.duration = duration;
  // the series in long double know no motors
  const bool solved = supports(world, initial, "taylor") && !hasActuators(world);
  if (solved) {
    reference.method = "taylor in long double";
    reference.states = seriesTrack(world, initial, duration, kInstants);
  } else {
    reference.method = "dop853";
    reference.states = refined(world, initial, "dop853", duration, nullptr);
  }
  Track check;
  if (solved && world.wrenches.empty() && !hasPivots(world)) {
    // the free top is the better of the two: it accumulates nothing where a rotation is unstable
    reference.check = "the exact rotation";
    check = freeTrack(world, initial, duration, kInstants);
    std::swap(reference.method, reference.check);
    std::swap(reference.states, check);
  } else {
    const bool conservative = supports(world, initial, "kahan_li8");
    reference.check = solved ? "dop853" : conservative ? "kahan_li8" : "rk4";
    check = refined(world, initial, reference.check, duration, &reference.states);
  }
  reference.doubt = errorsOf(world, check, reference.states);
  return reference;
}

}  // namespace rigid_body_sim
