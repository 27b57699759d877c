// Mass properties of a mesh file, of the bodies of a scene, or of the links of a URDF file.
#include <cstdio>

#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/mass_properties/mass_properties_formats.hpp"

namespace rigid_body_sim {
namespace {

/// Returns the exit status: faults of single links leave the others printed.
int run(const MassPropertiesOptions& options) {
  const Masses masses = readMasses(options);
  if (!masses.bodies.empty()) print(formatted(masses.bodies, options.format));
  for (const std::string& notice : masses.notices)
    std::fprintf(stderr, "%s\n", noticeLine("mass_properties", notice).c_str());
  for (const std::string& fault : masses.faults)
    std::fprintf(stderr, "mass_properties: %s\n", fault.c_str());
  return masses.faults.empty() ? kDone : kBadInput;
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  int code = kDone;
  const int failure = runProgram("mass_properties", [&] {
    const MassPropertiesOptions options = parseMassPropertiesOptions(argc, argv);
    if (options.help)
      print(massPropertiesHelp());
    else
      code = run(options);
  });
  return failure == kDone ? code : failure;
}
