#pragma once

#include <rigid_body_sim/dynamics/totals.hpp>

#include "dynamics/run/motion_piece.hpp"

namespace rigid_body_sim {

/// Sums what bodies exchange with what is around them while they move:
///   work: ∫ Σ (f · v + τ · ω) dt of applied wrenches and laws with a flow, and ∫ externalPower dt
///   of
///     the other laws, which is all that no potential energy accounts for
///   impulse: ∫ Σ f dt of all forces, gravity and laws included
///   angular impulse: ∫ Σ (x × f + τ) dt likewise, about the world's origin
///
/// A pivot does no work; its force, which follows from how the body accelerates, is part of the
/// impulse and has the torque x × f about the origin.
///
/// Of motors, work is what they put into the body, their wheels and rotors, and the air.
///
/// Each by a Gauss–Legendre rule over each piece of the motion; where the integrator does the
/// piece, the rule is of a higher order, so that what is left of a balance is the integrator's
/// error. A decay that a step does not resolve is not resolved by the rule either.
class ExchangeMeter {
 public:
  /// Adds what is exchanged over a piece. Not numbers where a part of it cannot be followed.
  void operator()(const MotionPiece& piece);

  /// Adds energy that a switch of a law's mode took out of its potential, or put into it [J].
  void addEnergy(double energy) { sum_.energy += energy; }

  /// Adds by what the bodies' own totals differ where they are put to rest.
  void addChange(const System& system, const SystemState& before, const SystemState& after);

  /// Since it was made or last taken.
  Totals take();

 private:
  void add(double weight, const System& system);
  void addPivot(double weight, const System::Pivot& pivot, const System& system);
  void addMotors(double weight, const System::Driven& driven, const System& system);

  Totals sum_;
  SystemState states_;  // at a node
  Workspace workspace_;
};

}  // namespace rigid_body_sim
