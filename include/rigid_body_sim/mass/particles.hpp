#pragma once

#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// A point mass; position and velocity in the axes of any one frame.
/// Formulas of this file: Rotenberg, "Rigid Body Motion", dynamics of particles.
struct Particle {
  double mass = 0;                       ///< [kg] >= 0
  Vector3d position = Vector3d::Zero();  ///< [m]
  Vector3d velocity = Vector3d::Zero();  ///< [m/s]
};
using Particles = std::vector<Particle>;

/// p = m v  [kg m/s]
Vector3d momentum(const Particle& particle);

/// Moment of momentum (angular momentum) about the point:  L = r × p,  r = x − point  [kg m²/s]
Vector3d momentOfMomentum(const Particle& particle, const Vector3d& point);

/// Moment (torque) about the point of a force acting at x:  τ = r × f,  r = x − point  [N m]
Vector3d momentOfForce(const Vector3d& x, const Vector3d& force, const Vector3d& point);

/// Inertia of a point mass at r from the centre of rotation:  I = −m hat(r) hat(r)  [kg m²]
Matrix3d pointInertia(double mass, const Vector3d& r);

/// m = Σ mᵢ  [kg]
double mass(const Particles& particles);

/// x_cm = Σ mᵢ xᵢ / m  [m]; zero for a system without mass
Vector3d centerOfMass(const Particles& particles);

/// p_cm = Σ mᵢ vᵢ = m v_cm  [kg m/s]
Vector3d momentum(const Particles& particles);

/// L_cm = Σ rᵢ × mᵢ vᵢ,  rᵢ = xᵢ − x_cm  [kg m²/s], computed as Σ rᵢ × mᵢ (vᵢ − v_cm): the same,
/// since Σ mᵢ rᵢ = 0, and a fast system loses no digits.
Vector3d angularMomentum(const Particles& particles);

/// Mass properties of the particles held rigidly:  I = −Σ mᵢ hat(rᵢ) hat(rᵢ),  rᵢ = xᵢ − x_cm.
/// Singular for particles on one line, which is no rigid body in three dimensions.
MassProperties massProperties(const Particles& particles);

}  // namespace rigid_body_sim
