#include <algorithm>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/math/rotation.hpp>

#include "dynamics/run/magnified_text.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kStartsApart = 1e-10;  // 1e-6 of what it grows to is rounding

/// A start that differs by so little that nothing but its growth shows.
State startBeside(const World& world, State start) {
  start.anchors.clear();
  start.plans.clear();
  start.near_laws.clear();
  const Vector3d generic = Vector3d(0.6, 0.48, 0.64);  // along no axis that a body turns about
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    BodyState& body = start.bodies[i];
    body.q_WP = product(body.q_WP, rotationExp(Vector3d(kStartsApart * generic))).normalized();
    body.L_P +=
        kStartsApart * stableNorm(body.L_P) * Vector3d(generic.z(), generic.x(), generic.y());
    body.L_W = rotate(body.q_WP, body.L_P);
  }
  return start;
}

bool isSolvedThroughout(const Simulation& simulation) {
  const std::vector<MotionPlan> plans = simulation.plans();
  return std::all_of(plans.begin(), plans.end(),
                     [](const MotionPlan& plan) { return plan.integrator.empty(); });
}

/// [rad] About what all bodies turn by from one state to another, as fast as they turn at either.
double turnBetween(const World& world, const State& start, const State& end) {
  double rate = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    for (const State* state : {&start, &end})
      rate += stableNorm(angularVelocity(world.bodies[i].inv_I, state->bodies[i].L_P));
  }
  return rate * (end.t - start.t);
}

/// Whether a second run is a matter of a tenth of a second, of steps and pieces of series.
bool isCheap(const Simulation& simulation, const State& start) {
  constexpr double kMaxTriedSteps = 1e5, kMaxTriedTurn = 1e5;
  const World& world = simulation.world();
  const double steps = (simulation.time() - start.t) / world.solver.time_step;
  return steps * static_cast<double>(world.bodies.size()) <= kMaxTriedSteps && world.laws.empty() &&
         turnBetween(world, start, simulation.state()) <= kMaxTriedTurn;
}

}  // namespace

std::string describeInstability(const Simulation& simulation, const State& start) {
  constexpr double kHalfOfTheDigits = 1e8;
  const World& world = simulation.world();
  if (!isSolvedThroughout(simulation) || !isCheap(simulation, start)) return "";
  Simulation beside(world, startBeside(world, start));
  try {
    beside.step(simulation.steps() - beside.steps());
  } catch (const SimulationDiverged&) {
    return "";  // nothing that the run itself would not have said
  }
  double most = 0;
  std::size_t which = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    const double apart = angleBetween(beside.body(i).q_WP, simulation.body(i).q_WP) / kStartsApart;
    if (apart > most) which = i;
    most = std::max(most, apart);
  }
  return most > kHalfOfTheDigits ? magnifiedText(world.bodies[which], most, SolvedBy::kSeries) : "";
}

}  // namespace rigid_body_sim
