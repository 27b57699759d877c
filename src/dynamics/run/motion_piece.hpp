#pragma once

#include "dynamics/methods/take_step.hpp"
#include "dynamics/run/solved_motion.hpp"

namespace rigid_body_sim {

/// The motion of bodies that act on one another between two instants: a stretch of a solution, or a
/// substep of an integrator. Nothing starts, ends or switches within it. The whole motion of a
/// group is a sequence of these (Group::advance): balances sample them, events are located on them.
class MotionPiece {
 public:
  /// laws: the laws' own states, but for the time of motors.
  MotionPiece(const System& system, const SolvedMotion& motion, const std::vector<double>& laws,
              double start, double end);

  /// at_start: before the substep; scratch: memory for shorter steps.
  MotionPiece(const System& system, const Method& method, const SystemState& at_start, double start,
              double end, Workspace& scratch);

  const System& system() const { return system_; }
  double start() const { return start_; }
  double end() const { return end_; }

  /// The states at start <= t <= end: a solution is evaluated; an integrator takes a shorter step
  /// from the start. Throws StepTooLong.
  void at(double t, SystemState& states) const;

  /// Nodes with which a Gauss–Legendre rule integrates over the piece what follows from its states.
  int gaussNodes() const;

 private:
  const System& system_;
  const SolvedMotion* motion_ = nullptr;  // or, where null,
  const Method* method_ = nullptr;        // with
  const std::vector<double>* laws_ = nullptr;
  const SystemState* at_start_ = nullptr;  // and
  Workspace* scratch_ = nullptr;
  double start_;
  double end_;
};

}  // namespace rigid_body_sim
