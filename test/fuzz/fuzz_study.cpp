#include <cstddef>
#include <cstdint>
#include <string>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "fuzz/one_line.hpp"
#include "scene/study/study.hpp"

/// Any text is read as a study, or refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  try {
    parseStudy(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml");
  } catch (const SceneError& refused) {
    requireOneLine(refused.what());
  }
  return 0;
}
