#include "tools/mass_properties/mass_properties_options.hpp"

#include "programs/usage.hpp"

namespace rigid_body_sim {
namespace {

MassFormat formatNamed(const std::string& name) {
  if (name == "text") return MassFormat::kText;
  if (name == "urdf") return MassFormat::kUrdf;
  if (name == "yaml") return MassFormat::kYaml;
  throw UsageError("--format: must be text, urdf or yaml, got '" + name + "'");
}

}  // namespace

MassPropertiesOptions parseMassPropertiesOptions(int argc, char** argv) {
  MassPropertiesOptions options;
  const OptionActions actions{numberInto(options.density, "density"),
                              numberInto(options.mass, "mass"),
                              numberInto(options.scale, "scale"),
                              {"format", [&](const char* s) { options.format = formatNamed(s); }}};
  const auto file = readCommandLine(argc, argv, actions, "file");
  options.help = !file;
  if (options.density && options.mass) throw UsageError("--density cannot stand beside --mass");
  options.file = file.value_or("");
  return options;
}

std::string massPropertiesHelp() {
  return R"(usage: mass_properties FILE [options]
Mass, centre of mass and inertia, with the principal moments and axes, of
  a mesh (.stl, .obj, .dae): the homogeneous solid within its surface, which must be closed;
  a URDF file (.urdf, .xml): every link with an <inertial>;
  a scene (any other name): every body.

  --density X        of a mesh [kg/m^3]; default 1000, and the output says so
  --mass X           of a mesh [kg], in place of a density
  --scale X          multiplies every length of a mesh: 0.001 for one in millimetres
  --format text      for people, 10 digits (default)
           yaml      entries for the `bodies` of a scene; numbers read back as the same; a name
                     that a scene does not accept is changed, and the line says so
           urdf      <inertial> elements; numbers read back as the same
  --help             this text

Inertia [kg m^2] is about the centre of mass in the axes of the body frame, which for a mesh is the
frame of the file. ixy is the entry of the matrix, as in URDF: -(integral of x y dm).
Exit status: 0 done, 1 the input is at fault, 2 wrong usage.
)";
}

}  // namespace rigid_body_sim
