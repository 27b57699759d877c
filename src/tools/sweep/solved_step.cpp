#include "tools/sweep/solved_step.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {
namespace {

/// Whether no law couples bodies, and no wrench that is to come ends a solved motion.
bool mayBeSolved(const World& world) {
  return world.solver.integrator == "auto" &&
         std::all_of(world.laws.begin(), world.laws.end(),
                     [](const auto& law) { return law->isOfMedium(); }) &&
         std::all_of(world.wrenches.begin(), world.wrenches.end(), HeldWrench::holds);
}

/// Whether the motion of every body is solved now.
bool everyMotionIsSolved(const Simulation& simulation) {
  const std::vector<MotionPlan> plans = simulation.plans();
  return std::all_of(plans.begin(), plans.end(),
                     [](const MotionPlan& plan) { return plan.integrator.empty(); });
}

}  // namespace

bool staysSolved(const Simulation& simulation) {
  return mayBeSolved(simulation.world()) && everyMotionIsSolved(simulation);
}

Simulation quickSimulation(World world, const State& initial, double duration) {
  if (!mayBeSolved(world)) return Simulation(std::move(world), initial);
  const double time_step = std::exchange(world.solver.time_step, duration);
  Simulation simulation(std::move(world), initial);
  if (everyMotionIsSolved(simulation)) return simulation;
  World in_steps = simulation.world();
  in_steps.solver.time_step = time_step;
  return Simulation(std::move(in_steps), initial);
}

}  // namespace rigid_body_sim
