#pragma once

#include <rigid_body_sim/dynamics/state.hpp>
#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// Adds the drag on a body, with v the velocity of its centre of mass:
///   f = −(linear + quadratic |v|) v,   τ = −angular ω.
void addDrag(const Body& body, const BodyState& state, Wrench& wrench);

/// [W] what drag dissipates, >= 0:  (linear + quadratic |v|) v² + angular ω².
double dragPower(const Body& body, const BodyState& state);

/// [1/s] The greatest rate at which drag slows down a body of that speed [m/s].
double dragRate(const Body& body, double speed);

/// The flow over h of drag together with a wrench, at fixed place and attitude:
///   p' = f − (linear + quadratic |p|/m) p/m,   L_P,i' = τ_P,i − angular L_P,i/I_i.
/// The angular part is exact, and so is the linear; quadratic drag acts as linear drag of the mean
/// speed of start and end, which is symmetric, of second order, and exact at the terminal velocity.
/// However stiff the drag, the motion stays finite and ends where it must; over a step that
/// quadratic drag outruns, it is slowed down too soon. h may be negative where there is no
/// quadratic drag.
void dragKick(const Body& body, const Wrench& wrench, double h, BodyState& state);

}  // namespace rigid_body_sim
