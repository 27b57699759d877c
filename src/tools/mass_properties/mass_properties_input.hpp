#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>

#include "tools/mass_properties/mass_properties_options.hpp"

namespace rigid_body_sim {

/// A body to report.
struct NamedMass {
  std::string name;
  std::string remark;  ///< what its figures rest on; may be empty
  MassProperties mass;
};

/// What a file holds.
struct Masses {
  std::vector<NamedMass> bodies;
  std::vector<std::string> notices;  ///< what its reader put right
  std::vector<std::string> faults;  ///< the links of a URDF file that no body can be, with the rule
};

/// The bodies of the file that the command line names, told apart by its extension. Throws
/// std::runtime_error for a file at fault as a whole, and UsageError for a density or mass that
/// does not go with the file.
Masses readMasses(const MassPropertiesOptions& options);

}  // namespace rigid_body_sim
