// Mass properties of a mesh file, of the bodies of a scene, or of the links of a URDF file.
#include <cstdio>
#include <exception>

#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/preface.hpp"
#include "tools/mass_properties/mass_properties_formats.hpp"

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  try {
    const MassPropertiesOptions options = parseMassPropertiesOptions(argc, argv);
    const Masses masses = options.help ? Masses() : readMasses(options);
    const std::string out = options.help            ? massPropertiesHelp()
                            : masses.bodies.empty() ? std::string()
                                                    : formatted(masses.bodies, options.format);
    if (std::fputs(out.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
      std::perror("mass_properties: standard output");
      return kBadInput;
    }
    Preface preface;
    for (const std::string& notice : masses.notices)
      preface.add(noticeLine("mass_properties", notice));
    for (const std::string& fault : masses.faults) preface.add("mass_properties: " + fault);
    preface.say();
    return masses.faults.empty() ? kDone : kBadInput;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "mass_properties: %s (mass_properties --help)\n", error.what());
    return kWrongUsage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mass_properties: %s\n", error.what());
    return kBadInput;
  }
}
