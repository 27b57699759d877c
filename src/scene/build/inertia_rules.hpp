#pragma once

#include <string>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// Says which rule the mass properties of a body break (massPropertiesFault), and how a scene can
/// go on where there is a way; empty when none.
std::string bodyMassFault(const MassProperties& m);

/// The same for a part of a body, which may have less extent than a body: a rod, a point mass, or a
/// frame without mass.
std::string partMassFault(const MassProperties& m);

/// Adds the same amount to the three principal moments, the least that meets the triangle
/// inequality, where that is the only rule broken. Returns a notice of what was done; empty when
/// nothing was.
std::string balanceInertia(MassProperties& m);

}  // namespace rigid_body_sim
