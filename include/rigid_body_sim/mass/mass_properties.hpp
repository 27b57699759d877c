#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Mass and its first and second moments, in the axes of a body frame B. Additive.
struct MassProperties {
  double mass = 0;                    ///< [kg]
  Vector3d com_B = Vector3d::Zero();  ///< [m] centre of mass
  Matrix3d I_Bcm = Matrix3d::Zero();  ///< [kg m²] about the centre of mass, symmetric
};

/// Inertia about a point at distance d from the centre of mass (parallel axes, Huygens–Steiner):
///   I = I_cm − m hat(d) hat(d).
Matrix3d parallelAxes(const Matrix3d& I_cm, double mass, const Vector3d& d);

/// Parts held rigidly together, all given in B:
///   m = Σ mᵢ,  com = Σ mᵢ comᵢ / m,  I = Σ (Iᵢ − mᵢ hat(dᵢ) hat(dᵢ)),  dᵢ = comᵢ − com.
/// The sums are compensated, so the order of many parts shows in the last digit at most. An error
/// of com enters the inertia squared: parts far from the origin of B keep their digits. A part
/// without mass adds its inertia alone; a whole without mass has its centre at the origin of B. A
/// hole is a part of negative mass with the matching negative inertia.
MassProperties combined(const std::vector<MassProperties>& parts);

/// Two parts held rigidly together, both given in B; see combined.
MassProperties operator+(const MassProperties& a, const MassProperties& b);

/// The same matter given in axes A instead of B:  com_A = X_AB com_B,  I_A = R I_B Rᵀ, made
/// symmetric to the last bit.
MassProperties transformed(const Isometry3d& X_AB, const MassProperties& part_B);

/// Says which rule a rigid body's mass properties break, with the figures; empty when none:
/// finite; mass > 0; inertia symmetric (to 1e-12 of its greatest entry), positive definite and
/// within the triangle inequality I₁ + I₂ ≥ I₃ of its principal moments; mass and moments so large,
/// about 6e-309, that their inverses are finite.
/// Rounding is allowed for: a flat plate (equality) passes by 1e-9 of the greatest moment, and
/// positive definite means a least moment above 1e-15 of the greatest, below which nothing but
/// rounding can be read from the matrix (particles on one line); needles of ratio 1e12 pass.
std::string massPropertiesFault(const MassProperties& m);

}  // namespace rigid_body_sim
