#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <rigid_body_sim/dynamics/drag.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/reference_motion.hpp"

/// The laws of force, written anew in long double.
namespace rigid_body_sim::reference {

/// Adds the loads of a law.
using Law = std::function<void(const std::vector<Body>&, const Motions&, Loads&)>;

/// tension = k (l − l₀) + c dl/dt along the line between the ends.
Law spring(const Spring::End& from, const Spring::End& to, const Spring::Constants& constants);

/// f = −mu m r/|r|³,  τ = 3 mu/|r|⁵ r × (R I Rᵀ r)
Law centralGravity(std::size_t body, const Vector3d& center, double mu, bool gradient);

/// f = −(linear + quadratic |v|) v,  τ = −angular ω
Law drag(std::size_t body, const Drag::Coefficients& drag);

/// With u = v + ω × c − w, along the axes e_i of the drag:
///   f = −(linear + quadratic |u|) u − Σ (linear_i + quadratic_i |u_i|) u_i e_i at c,
///   τ = −angular ω − Σ angular_i ω_i e_i
Law mediumDrag(std::size_t body, const MediumDrag::Coefficients& drag, const Vector3d& w_W);

/// f = −ρ V g at the centroid
Law buoyancy(std::size_t body, double displaced, const Vector3d& centroid_P, const Vector3d& g_W);

}  // namespace rigid_body_sim::reference
