#include "dynamics/state_of_world.hpp"

#include <algorithm>

#include "dynamics/require.hpp"

namespace rigid_body_sim {
namespace {

void requireActuatorsOf(const World& world, const State& state) {
  if (state.actuators.empty()) return;
  require(state.actuators.size() == world.bodies.size(),
          "a state must have actuators for each body, or for none");
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    require(state.actuators[i].size() == world.bodies[i].actuators.size(), "body '",
            world.bodies[i].name, "': a state must have as many actuators as its world");
}

}  // namespace

void requireStateOf(const World& world, const State& state) {
  require(state.bodies.size() == world.bodies.size(),
          "a state must have as many bodies as its world, ", world.bodies.size(), ", got ",
          state.bodies.size());
  std::size_t law_states = 0;
  if (!state.laws.empty())
    for (const auto& law : world.laws) law_states += law->stateCount();
  require(state.laws.size() == law_states,
          "a state must have as many states of laws as its world, ", law_states, ", got ",
          state.laws.size());
  requireActuatorsOf(world, state);
  require(state.changes.empty() || state.changes.size() == world.bodies.size(),
          "a state must have changes for each body, or for none");
  const bool changed = std::any_of(state.changes.begin(), state.changes.end(),
                                   [](const BodyChange& change) { return change.any(); });
  require(!changed || world.unchanged,
          "the state has changes of bodies which the world lacks: take the world that the "
          "simulation gives, or withChanges");
}

}  // namespace rigid_body_sim
