#include "mass_properties_options.hpp"

#include <getopt.h>

#include "usage.hpp"

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
  static const option known[] = {{"density", required_argument, nullptr, 'd'},
                                 {"mass", required_argument, nullptr, 'm'},
                                 {"format", required_argument, nullptr, 'f'},
                                 {"help", no_argument, nullptr, 'h'},
                                 {nullptr, 0, nullptr, 0}};
  MassPropertiesOptions options;
  opterr = 0;  // the message below is ours
  for (int code; (code = getopt_long(argc, argv, ":h", known, nullptr)) != -1;) {
    switch (code) {
      case 'd':
        options.density = positiveNumber("density", optarg);
        break;
      case 'm':
        options.mass = positiveNumber("mass", optarg);
        break;
      case 'f':
        options.format = formatNamed(optarg);
        break;
      case 'h':
        options.help = true;
        break;
      case ':':
        throw UsageError(std::string(argv[optind - 1]) + " needs a value");
      default:
        throw UsageError("unknown option " + std::string(argv[optind - 1]));
    }
  }
  if (options.help) return options;
  if (options.density && options.mass) throw UsageError("--density cannot stand beside --mass");
  if (optind + 1 != argc)
    throw UsageError("exactly one file is needed, got " + std::to_string(argc - optind));
  options.file = argv[optind];
  return options;
}

std::string massPropertiesHelp() {
  return R"(usage: mass_properties FILE [options]
Mass, centre of mass and inertia, with the principal moments and axes, of
  a mesh (.stl, .obj, .dae): the homogeneous solid within its surface, which must be closed;
  a scene (.yaml, .yml): every body;
  a URDF file (.urdf, .xml): every link with an <inertial>.

  --density X        of a mesh [kg/m^3]; default 1000, and the output says so
  --mass X           of a mesh [kg], in place of a density
  --format text      for people, 10 digits (default)
           yaml      entries for the `bodies` of a scene, 17 digits: nothing is lost
           urdf      <inertial> elements, 17 digits
  --help             this text

Inertia [kg m^2] is about the centre of mass in the axes of the body frame, which for a mesh is the
frame of the file. ixy is the entry of the matrix, as in URDF: -(integral of x y dm).
Exit status: 0 done, 1 the input is at fault, 2 wrong usage.
)";
}

}  // namespace rigid_body_sim
