#pragma once

#include <rigid_body_sim/dynamics/contact.hpp>

#include "support/worlds.hpp"

/// Bodies that touch planes and one another.
namespace rigid_body_sim::test {

ContactShape ballShape(double radius);

/// The corners of a box, in axes in which its principal axes are its own.
ContactShape cornersOf(const Body& body, const Vector3d& size);

ContactParameters contactOf(double stiffness, double exponent, double dissipation, double friction);

/// A plane through the origin that falls off along x by an angle [rad].
HalfSpace slope(double angle);

/// Adds a ball and its contact with a plane; its motion is of its centre.
std::size_t addBall(Bench& bench, double radius, double mass, const BodyFrameMotion& motion,
                    const HalfSpace& plane, const ContactParameters& parameters);

/// Contact between two balls of a bench.
void letTouch(Bench& bench, std::size_t a, double radius_a, std::size_t b, double radius_b,
              const ContactParameters& parameters);

/// The same of a box by its corners.
std::size_t addBox(Bench& bench, const Vector3d& size, double mass, const BodyFrameMotion& motion,
                   const HalfSpace& plane, const ContactParameters& parameters);

BodyFrameMotion motionAt(const Vector3d& x_W, const Vector3d& v_W = Vector3d::Zero(),
                         const Vector3d& w_W = Vector3d::Zero());

/// Two balls, one nearly above the other, over ground that they fall on; they touch each other,
/// too. x, y [m]: how far the upper one is to the side.
Bench stackedBalls(double x, double y);

/// With auto, at a stated tolerance, and at the steps that it asks for before any trial.
Simulation simulationAt(Bench bench, double tolerance, double time_step);

}  // namespace rigid_body_sim::test
