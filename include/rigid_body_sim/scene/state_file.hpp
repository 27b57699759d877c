#pragma once

#include <string>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

/// Saved states: everything from which a run goes on with the same bits, as text that keeps every
/// bit; doc/state_file.md describes the format. A state is of one world: of its scene (World::
/// fingerprint), its bodies and their masses, its solver.

/// The text of a state that Simulation::state() gave. Throws std::invalid_argument for one that
/// could not be read back: with numbers that are not finite, or too large for a file.
std::string stateText(const World& world, const State& state);

/// The state in a text; source stands for the file in messages. Throws SceneError, one line, for a
/// text that is cut short, of another version, or of another world, and for a value that breaks its
/// rule.
State parseState(const std::string& text, const std::string& source, const World& world);

/// The same to and from a file. A file is replaced once all has been written, or not at all. Both
/// throw SceneError, too, where the file cannot be written or read.
void saveState(const std::string& path, const World& world, const State& state);
State loadState(const std::string& path, const World& world);

/// Throws SceneError, as saveState would, where no file can be made at the path. Leaves what is
/// there as it is.
void requireSavable(const std::string& path);

}  // namespace rigid_body_sim
