#pragma once

#include <optional>
#include <string>

namespace rigid_body_sim {

enum class MassFormat { kText, kUrdf, kYaml };

/// What the command line of `mass_properties` says.
struct MassPropertiesOptions {
  std::string file;               ///< mesh, scene or URDF
  std::optional<double> density;  ///< [kg/m³] > 0, of a mesh
  std::optional<double> mass;     ///< [kg] > 0, of a mesh
  std::optional<double> scale;    ///< > 0, multiplies every length of a mesh
  MassFormat format = MassFormat::kText;
  bool help = false;
};

/// Throws UsageError for an unknown option, a value against its rule, density beside mass, or not
/// exactly one file.
MassPropertiesOptions parseMassPropertiesOptions(int argc, char** argv);

/// The text of --help.
std::string massPropertiesHelp();

}  // namespace rigid_body_sim
