#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// Three indices of vertices, counter-clockwise as seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Surface of a homogeneous solid. A cavity is a closed surface of its own inside the outer one,
/// whose triangles too are counter-clockwise as seen from outside the matter, that is, from within
/// the cavity.
struct TriangleMesh {
  std::vector<Vector3d> vertices;  ///< [m]
  std::vector<Triangle> triangles;
};

/// Volume [m³] enclosed by a closed mesh (see checkedMesh); negative if it is oriented inwards.
double volume(const TriangleMesh& mesh);

/// Mass properties of the homogeneous solid of the given mass [kg] within a closed mesh of volume
/// other than zero, in the axes of its vertices. The orientation cancels out.
///
/// Exact integrals over the surface by the divergence theorem with the field f r, r = x − c: over a
/// triangle with corners a, b, c (taken from the reference point), s = a + b + c and
/// d = a · (b − a) × (c − a), that is six times the signed volume of its tetrahedron,
///   ∫ dV = d/6,   ∫ r dV = d/24 s,   ∫ r rᵀ dV = d/120 (a aᵀ + b bᵀ + c cᵀ + s sᵀ).
/// The reference point is the middle of the mesh for volume and centre of mass, then the centre of
/// mass for the inertia: a mesh far from the origin loses no more than its vertices have lost, and
/// thin plates sum terms of one sign. All sums are compensated.
/// Source: Mirtich 1996, "Fast and accurate computation of polyhedral mass properties"; Eberly,
/// "Polyhedral mass properties (revisited)". Their fields (x², 0, 0) … give the same integrals but
/// prefer the coordinate axes, so that rotated plates cancel.
MassProperties massProperties(const TriangleMesh& mesh, double mass);

}  // namespace rigid_body_sim
