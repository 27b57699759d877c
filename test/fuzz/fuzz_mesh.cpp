#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "fuzz/one_line.hpp"
#include "scene/meshes/read_dae.hpp"
#include "scene/meshes/read_obj.hpp"
#include "scene/meshes/read_stl.hpp"

/// The bytes of a mesh file, after a first byte that says of which format, give a solid or are
/// refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  if (size < 2) return -1;
  const std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  std::string fault;
  try {
    const FileMesh file = data[0] % 3 == 0   ? readStl(bytes)
                          : data[0] % 3 == 1 ? readObj(bytes)
                                             : readDae(bytes);
    const CheckedMesh checked = checkedMesh(file.mesh, file.rounding);
    fault = checked.fault;
    if (fault.empty() && !(volume(checked.mesh) > 0)) std::abort();
  } catch (const std::runtime_error& refused) {
    fault = refused.what();
  }
  requireOneLine(fault, 1000);
  return 0;
}
