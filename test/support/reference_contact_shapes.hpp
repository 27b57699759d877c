#pragma once

#include "support/reference_contact_law.hpp"

/// Where bodies of the independent reference of contact touch planes and one another.
namespace rigid_body_sim::contact_reference {

/// Solid below the plane through `origin` of unit normal n.
struct Ground {
  Vec origin, n;
};

/// A corner at r, in body axes.
Element corner(std::size_t body, const Rigid& rigid, const Vec& r, const Ground& ground,
               const Law& law);

/// A ball about c: its lowest point lies a radius below the centre.
Element ball(std::size_t body, const Rigid& rigid, const Vec& c, Real radius, const Ground& ground,
             const Law& law);

/// An ellipsoid about the centre of mass: of the points x with |x/D| = 1 the one with least n · R
/// x.
Element ellipsoid(std::size_t body, const Rigid& rigid, const Vec& semi_axes, const Ground& ground,
                  const Law& law);

/// A rim about the body's z axis at height z: its lowest point, the two at the height of its
/// centre, and its highest. Not for one that lies flat.
Element rim(std::size_t body, const Rigid& rigid, Real z, Real radius, const Ground& ground,
            const Law& law);

/// Two balls about their centres of mass.
Element balls(std::size_t a, const Rigid& of_a, Real radius_a, std::size_t b, const Rigid& of_b,
              Real radius_b, const Law& law);

}  // namespace rigid_body_sim::contact_reference
