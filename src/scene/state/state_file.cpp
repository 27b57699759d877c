#include <filesystem>
#include <stdexcept>
#include <system_error>

#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "dynamics/world_changes.hpp"
#include "scene/files/read_file.hpp"
#include "scene/files/write_file.hpp"
#include "scene/limits.hpp"
#include "scene/state/state_format.hpp"

namespace rigid_body_sim {
namespace {

void requireWritten(const std::string& path, const std::error_code& fault) {
  if (fault) throw SceneError(path, 0, "cannot be written: " + fault.message());
}

}  // namespace

std::string stateText(const World& world, const State& state) {
  bool any_moves = false;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const bool is_changed = i < state.changes.size() && state.changes[i].absent;
    const bool absent = is_changed ? *state.changes[i].absent : unchangedBodies(world)[i].absent;
    any_moves = any_moves || !(world.bodies[i].fixed || absent);
  }
  const bool lacks_plans = state.plans.empty() && !state.anchors.empty() && any_moves;
  const bool lacks_schedules =
      state.schedules.empty() && !(world.wrenches.empty() && world.commands.empty());
  if (state.bodies.size() != world.bodies.size() || lacks_plans || lacks_schedules)
    throw std::invalid_argument("the state must be one that a simulation of its world gave");
  std::string text = writtenState(world, state);
  try {
    parseState(text, "the state", world);
  } catch (const SceneError& fault) {
    throw std::invalid_argument(fault.what());
  }
  return text;
}

void requireSavable(const std::string& path) {
  std::error_code no_matter;
  if (std::filesystem::is_directory(path, no_matter))
    throw SceneError(path, 0, "is a directory, not a file for a state");
  requireWritten(path, writeFault(path));
}

void saveState(const std::string& path, const World& world, const State& state) {
  requireWritten(path, writeFile(path, stateText(world, state)));
}

State loadState(const std::string& path, const World& world) {
  return parseState(readFile(path, "saved state", kMaxSceneBytes), path, world);
}

}  // namespace rigid_body_sim
