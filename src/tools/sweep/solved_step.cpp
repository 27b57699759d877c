#include "tools/sweep/solved_step.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace rigid_body_sim {
namespace {

/// Whether no wrench turns with another body.
bool actsAlone(const PointWrench& wrench) {
  const auto own = [&](std::size_t frame) {
    return frame == kWorld || frame == kOwnBody || frame == wrench.body;
  };
  return own(wrench.axes) && own(wrench.point_frame);
}

bool mayBeSolved(const World& world) {
  return world.solver.integrator == "auto" && world.laws.empty() &&
         std::all_of(world.wrenches.begin(), world.wrenches.end(), actsAlone);
}

}  // namespace

bool everyMotionIsSolved(const Simulation& simulation) {
  const std::vector<MotionPlan> plans = simulation.plans();
  return std::all_of(plans.begin(), plans.end(),
                     [](const MotionPlan& plan) { return plan.integrator.empty(); });
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
