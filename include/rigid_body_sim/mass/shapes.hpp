#pragma once

#include <variant>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// Homogeneous solids, each centred on the origin of its own frame with its axes along the frame's.
struct Box {
  Vector3d size;  ///< [m] edge lengths, > 0
};
struct Sphere {
  double radius;  ///< [m] > 0
};
struct Cylinder {
  double radius;  ///< [m] > 0
  double length;  ///< [m] > 0, along z
};

using Shape = std::variant<Box, Sphere, Cylinder>;

/// Volume [m³] of the solid.
double volume(const Shape& shape);

/// Mass properties of the homogeneous solid of the given mass [kg], in the shape's frame.
///   box:      Iₓ = m (b² + c²)/12 and cyclic
///   sphere:   I = 2 m r²/5
///   cylinder: Iₓ = I_y = m (3 r² + l²)/12,  I_z = m r²/2
MassProperties massProperties(const Shape& shape, double mass);

}  // namespace rigid_body_sim
