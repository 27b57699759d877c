#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "fuzz/one_line.hpp"

namespace rigid_body_sim {
namespace {

/// The scene that the state in the corpus is of.
const char* const kSavedScene = R"(
time_step: 0.01
bodies:
  - {name: a, shape: {box: [1, 2, 3]}, mass: 1, wheels: {w: {axis: [0, 0, 1], inertia: 0.1}}}
  - {name: b, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0]}
wrenches:
  - {body: b, frame: a, force: [1, 2, 3], start: 0.02, duration: 3}
)";

Simulation simulationOfScene() {
  const Scene scene = parseScene(kSavedScene, "fuzz.yaml");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

}  // namespace
}  // namespace rigid_body_sim

/// Any text is read as a state from which a run goes on, or refused in one line: by the reader, or,
/// where its values cannot be a state, by the simulation.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  static const Simulation start = simulationOfScene();
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    Simulation(start).load(parseState(text, "fuzz", start.world()));
  } catch (const SceneError& refused) {
    requireOneLine(refused.what());
  } catch (const std::invalid_argument& refused) {
    requireOneLine(refused.what());
  }
  return 0;
}
