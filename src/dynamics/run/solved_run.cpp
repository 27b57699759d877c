#include "dynamics/run/solved_run.hpp"

#include <algorithm>

#include "dynamics/run/check_input.hpp"
#include "dynamics/run/run_state.hpp"

namespace rigid_body_sim {
namespace {

/// Neither owned nor copied: it outlives the pointer.
template <class T>
std::shared_ptr<const T> seen(const T& object) {
  return {std::shared_ptr<const T>(), &object};
}

}  // namespace

bool isSolvedThroughout(const World& world) {
  return world.solver.integrator == "auto" && world.laws.empty() && world.commands.empty() &&
         !world.unchanged &&
         std::all_of(world.bodies.begin(), world.bodies.end(),
                     [](const Body& body) { return body.actuators.empty(); }) &&
         std::all_of(world.wrenches.begin(), world.wrenches.end(), HeldWrench::holds);
}

std::vector<BodyState> solvedAfter(const World& world, const State& start, double duration) {
  checkWorld(world);
  checkState(world, start);
  RunState run(seen(world), seen(start));
  run.schedules.resize(world.bodies.size());
  for (const PointWrench& wrench : world.wrenches)
    run.schedules[wrench.body].put("", onSteps(wrench, duration), 0);
  std::vector<BodyState> bodies = start.bodies;
  MethodChoice choice;
  choice.read_once = true;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    run.schedules[i].advanceTo(0);
    Group group(world, run.laws, {{i}, {}, {}}, choice, 0, {start.bodies[i]}, {}, run.schedules);
    run.advance(group, duration, run.schedules, nullptr);
    bodies[i] = group.advanced().bodies.front();
  }
  return bodies;
}

}  // namespace rigid_body_sim
