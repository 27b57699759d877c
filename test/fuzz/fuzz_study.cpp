#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/study/study.hpp"

/// Any text is read as a study, or refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  try {
    parseStudy(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml");
  } catch (const SceneError& refused) {
    const std::string line = refused.what();
    if (line.find_first_of("\n\r") != std::string::npos || line.size() > 10000) std::abort();
  }
  return 0;
}
