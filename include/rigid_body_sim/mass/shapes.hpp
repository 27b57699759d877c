#pragma once

#include <variant>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// Homogeneous solids, each with its centre of mass at the origin of its own frame and its axes
/// along the frame's. massProperties throws std::invalid_argument for lengths that break a rule;
/// the mass is for makeBody to check, or massPropertiesFault, and volume checks nothing.
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
/// A cylinder closed by two half spheres.
struct Capsule {
  double radius;  ///< [m] > 0
  double length;  ///< [m] >= 0, along z, of the cylindrical part
};
struct Ellipsoid {
  Vector3d semi_axes;  ///< [m] > 0
};
/// Apex up: apex at z = 3/4 length, base at z = −1/4 length.
struct Cone {
  double radius;  ///< [m] > 0, of the base
  double length;  ///< [m] > 0, along z
};

using Shape = std::variant<Box, Sphere, Cylinder, Capsule, Ellipsoid, Cone>;

/// Volume [m³] of the solid.
///   box: a b c,  sphere: 4/3 π r³,  cylinder: π r² l,  capsule: π r² (l + 4/3 r),
///   ellipsoid: 4/3 π a b c,  cone: 1/3 π r² l
double volume(const Shape& shape);

/// Mass properties of the homogeneous solid of the given mass [kg], in the shape's frame.
///   box:       Iₓ = m (b² + c²)/12 and cyclic
///   sphere:    I = 2/5 m r²
///   cylinder:  Iₓ = I_y = m (3 r² + l²)/12,  I_z = m r²/2
///   capsule:   Iₓ = I_y = m_c (3 r² + l²)/12 + m_s (2/5 r² + 3/8 r l + l²/4),
///              I_z = m_c r²/2 + 2/5 m_s r²,  with the cylinder's share m_c = m l/(l + 4/3 r) and
///              the caps' m_s = m − m_c (a half sphere's centre of mass is 3/8 r from its face)
///   ellipsoid: Iₓ = m (b² + c²)/5 and cyclic
///   cone:      Iₓ = I_y = 3/80 m (4 r² + l²),  I_z = 3/10 m r²
MassProperties massProperties(const Shape& shape, double mass);

}  // namespace rigid_body_sim
