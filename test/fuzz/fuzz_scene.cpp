#include <cstddef>
#include <cstdint>
#include <string>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "fuzz/one_line.hpp"

/// Any text is read to the state that a simulation starts from, or refused in one line. To be run
/// in an empty directory, for a scene may name files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  try {
    const Scene scene =
        parseScene(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml");
    const World world = buildWorld(scene);
    initialState(scene, world);
  } catch (const SceneError& refused) {
    requireOneLine(refused.what());
  }
  return 0;
}
