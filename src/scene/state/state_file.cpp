#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "dynamics/world_changes.hpp"
#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/state/state_format.hpp"

namespace rigid_body_sim {
namespace {

/// Whether nothing can take its place: a device or a pipe.
bool isWrittenThrough(const std::string& path) {
  std::error_code is_gone;
  const std::filesystem::file_status there = std::filesystem::status(path, is_gone);
  return std::filesystem::exists(there) && !std::filesystem::is_regular_file(there);
}

/// That to which links lead, so that they stay.
std::string targetOf(const std::string& path) {
  std::error_code fault;
  const std::string target = std::filesystem::canonical(path, fault).string();
  return fault ? path : target;
}

/// In the same directory, so that it can take the place of the file at once.
std::string unfinished(const std::string& path) { return targetOf(path) + ".unfinished"; }

/// Writes a file; what went wrong.
std::error_code write(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return {};
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

void requireWritten(const std::string& path, const std::error_code& fault) {
  if (!fault) return;
  std::error_code no_matter;
  std::filesystem::remove(unfinished(path), no_matter);
  throw SceneError(path, 0, "cannot be written: " + fault.message());
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
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault))
    throw SceneError(path, 0, "is a directory, not a file for a state");
  if (isWrittenThrough(path)) return;
  fault = write(unfinished(path), "");
  if (!fault) std::filesystem::remove(unfinished(path), fault);
  requireWritten(path, fault);
}

void saveState(const std::string& path, const World& world, const State& state) {
  const std::string text = stateText(world, state);
  if (isWrittenThrough(path)) {
    const std::error_code fault = write(path, text);
    if (fault) throw SceneError(path, 0, "cannot be written: " + fault.message());
    return;
  }
  std::error_code fault = write(unfinished(path), text);
  if (!fault) std::filesystem::rename(unfinished(path), targetOf(path), fault);
  requireWritten(path, fault);
}

State loadState(const std::string& path, const World& world) {
  return parseState(readFile(path, "saved state", kMaxSceneBytes), path, world);
}

}  // namespace rigid_body_sim
