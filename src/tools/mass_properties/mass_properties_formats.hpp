#pragma once

#include <string>
#include <vector>

#include "tools/mass_properties/mass_properties_input.hpp"

namespace rigid_body_sim {

/// The figures of bodies, in the given format; see massPropertiesHelp.
std::string formatted(const std::vector<NamedMass>& masses, MassFormat format);

}  // namespace rigid_body_sim
