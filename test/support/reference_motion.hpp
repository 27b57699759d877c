#pragma once

#include <functional>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/state.hpp>

/// An independent reference: the plain Newton-Euler equations of any number of bodies under any
/// wrench function, in long double, by extrapolation of the modified midpoint rule. It shares no
/// formula with the methods under test beyond the laws of motion themselves.
namespace rigid_body_sim::reference {

using Real = long double;
using Vector = Vector3<Real>;
using Matrix = Matrix3<Real>;

/// What changes about a body; also its rate of change, with q not of unit norm.
struct Motion {
  Vector x = Vector::Zero();                          ///< [m] centre of mass, world axes
  Vector v = Vector::Zero();                          ///< [m/s] its velocity, world axes
  Quaternion<Real> q = Quaternion<Real>::Identity();  ///< principal axes in the world
  Vector w = Vector::Zero();                          ///< [rad/s] principal axes

  Matrix R() const;
};
using Motions = std::vector<Motion>;

/// Force on a body and torque about its centre of mass, the torque in two parts.
struct Load {
  Vector f_W = Vector::Zero();    ///< [N]
  Vector tau_W = Vector::Zero();  ///< [N m] world axes
  Vector tau_P = Vector::Zero();  ///< [N m] principal axes
};
using Loads = std::vector<Load>;

Motion toMotion(const Body& body, const BodyState& state);

/// The Load of each body at a time.
using Wrenches = std::function<Loads(Real t, const Motions&)>;

/// The motions a duration later. The wrenches must be smooth over it: split at their instants.
/// tolerance: of each step, relative; the default is what long double can hold. A step is also
/// done when extrapolation gains no more at 1e-12, being down at the rounding of the wrenches; a
/// kink of a wrench, such as where drag along an axis changes its sign, stops it earlier.
/// Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", II.9.
Motions advance(const std::vector<Body>& bodies, const Wrenches& wrenches, Motions motions, Real t,
                Real duration, Real first_step, Real tolerance = 2e-18L);

/// The same for one body.
Motion advance(const Body& body, const std::function<Load(Real t, const Motion&)>& wrench,
               const Motion& motion, Real t, Real duration, Real first_step,
               Real tolerance = 2e-18L);

/// Angle [rad] between a computed attitude and the reference.
Real attitudeError(const Quaterniond& q, const Motion& m);

}  // namespace rigid_body_sim::reference
