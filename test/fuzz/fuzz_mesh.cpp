#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <rigid_body_sim/scene/solid_mesh.hpp>

#include "support/temporary_directory.hpp"

/// assimp loses what it had read of a file when it gives up on the rest.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT: the name is the sanitizer's
  return "leak:libassimp";
}

/// The bytes of a mesh file, after a first byte that says of which format, give a solid or are
/// refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  if (size < 2) return -1;
  static const TemporaryDirectory directory;
  const std::string path = directory.path(data[0] % 2 == 0 ? "x.stl" : "x.obj");
  std::FILE* file = std::fopen(path.c_str(), "wb");
  std::fwrite(data + 1, 1, size - 1, file);
  std::fclose(file);
  try {
    const SolidMesh solid = readSolidMesh(path, 1);
    if (!(solid.def.volume > 0) || !solid.def.unit.I_Bcm.allFinite()) std::abort();
  } catch (const std::runtime_error& refused) {
    const std::string line = refused.what();
    if (line.find_first_of("\n\r") != std::string::npos || line.size() > 1000) std::abort();
  }
  return 0;
}
