#pragma once

#include <vector>

#include "dynamics/run/cubic_between.hpp"
#include "dynamics/run/eighths.hpp"
#include "dynamics/run/motion_piece.hpp"

namespace rigid_body_sim {

/// Finds where a guard of a law falls below zero within a substep.
class EventSearch {
 public:
  /// Of all laws of a system, law by law.
  static void setGuards(const System& system, const SystemState& states,
                        std::vector<double>& guards);

  /// The instant at which the first guard has just fallen below zero, located to the system's
  /// precision; the end of the piece where none does. at_end: the states there; they become those
  /// at the instant. What falls below zero and rises again within an eighth of the piece is looked
  /// for by a polynomial through the guard, or a parabola through what a cubic shows. cubic: what
  /// shows where to look at less cost; or null. goes_on: whether the piece begins where the last
  /// one has ended without an event.
  double firstEvent(const MotionPiece& piece, const SystemState& at_start, SystemState& at_end,
                    const CubicBetween* cubic = nullptr, bool goes_on = false);

  /// Whether the last firstEvent found one.
  bool found() const { return found_; }

 private:
  /// When the guards fall below zero, and how fast [1/s]; not known while that is not below zero.
  struct Crossing {
    double t = 0, slope = 0;
  };

  double locate(const MotionPiece& piece, double before, double after, SystemState& at_end,
                const CubicBetween* cubic);
  Crossing crossingOn(const CubicBetween& cubic, const MotionPiece& piece, double before,
                      double after, double low);
  double lowest(const System& system, const SystemState& states);
  double lowestShare() const;
  bool isBelowAt(const MotionPiece& piece, double eighths);
  double suspected(const MotionPiece& piece, const CubicBetween* cubic);
  double belowVertex(const MotionPiece& piece, std::size_t i);
  double belowBetween(const MotionPiece& piece, std::size_t i);
  bool isNearZero(std::size_t i, double least) const;
  bool comesNear() const;

  bool found_ = false;
  std::vector<double> guards_;
  std::vector<double> scales_;  // of the guards that are below zero at the end; else 0
  std::vector<std::vector<double>> samples_;  // guards at eighths of the piece
  SystemState trial_;
};

/// Switches the mode of each law a guard of which is below zero. Returns by how much potential
/// energies have risen [J], and adds touches and releases of contacts to `events`, at no time yet.
/// Throws StepTooLong where modes switch without end.
double switchModes(const System& system, SystemState& states, std::vector<ContactEvent>& events);

}  // namespace rigid_body_sim
