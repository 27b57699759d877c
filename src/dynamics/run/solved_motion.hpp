#pragma once

#include <algorithm>
#include <string>
#include <variant>

#include "dynamics/medium/medium_segment.hpp"
#include "dynamics/rotation/free_flight.hpp"
#include "dynamics/run/axial_flight.hpp"
#include "dynamics/step_too_long.hpp"
#include "dynamics/taylor/driven_segment.hpp"
#include "math/boxed.hpp"

namespace rigid_body_sim {

/// What the motion of one body is solved for: constant in the world or in the body.
struct SolvedProblem {
  const Body& body;
  const HeldWrench& wrench;
  const Vector3d& g_W;  ///< [m/s²]
  ErrorBound bound;     ///< none: to rounding
  /// Whether each piece of it is asked for one time only: then a free flight is solved in a way
  /// that is found in less time than it takes to evaluate; the same to rounding.
  bool read_once = false;
};

/// The motion of one body, solved from an anchor on: in closed form where there is no torque, or
/// one along the principal axis that the body turns about; else by a Taylor segment; one that is
/// driven where motors act, or one in a medium.
class SolvedMotion {
 public:
  /// Anchors the motion at a state of time t [s]; it is not asked for beyond `horizon` [s].
  SolvedMotion(const SolvedProblem& problem, double t, const BodyState& state, double horizon);

  /// Anchors the motion at another state, as if made anew.
  void anchorAnew(const SolvedProblem& same_problem, double t, const BodyState& state,
                  double horizon);

  /// Where it is anchored.
  MotionAnchor anchor() const;

  /// [s] the time up to which the solution holds; NaN where the motion is not finite.
  double validUntil() const { return valid_until_; }

  /// [s] Time up to which, from t on, a Gauss-Legendre rule sees all that happens; at most
  /// validUntil().
  double smoothUntil(double t) const;

  /// [s] Time up to which the solution is guaranteed finite, by one of its states; the anchor where
  /// the numbers are so large that only evaluation shows it.
  double finiteUntil(const BodyState& state) const;

  /// Whether it is known in closed form: then another anchor at validUntil() would not help it.
  bool isClosed() const {
    return std::holds_alternative<FreeFlight>(motion_) ||
           std::holds_alternative<AxialFlight>(motion_);
  }

  /// The flight that it is, begun at anchoredAt() [s]; null where it is another motion.
  const FreeFlight* asFlight() const { return std::get_if<FreeFlight>(&motion_); }
  double anchoredAt() const { return anchor_; }

  /// The state at a time [s] between the anchor and validUntil().
  BodyState at(double t) const;

 private:
  using Series = Boxed<TaylorSegment>;
  using Driven = Boxed<DrivenSegment>;
  using InMedium = Boxed<MediumSegment>;
  using Motion = std::variant<FreeFlight, AxialFlight, Series, Driven, InMedium>;
  static Motion solve(const SolvedProblem& problem, double t, const BodyState& state,
                      double duration);
  bool anchorDriven(const SolvedProblem& same_problem, double t, const BodyState& state);
  bool anchorInMedium(const SolvedProblem& same_problem, double t, const BodyState& state);

  double anchor_;
  double valid_until_ = 0;
  bool modest_;  // whether body and wrench are far from what overflows
  Motion motion_;
};

/// Why a motion cannot be followed from a state on: what is fastest in it, and what to do. stuck:
/// its series does not hold up to the next number that time can be; else only not over a step.
std::string tooFastText(const SolvedProblem& problem, const BodyState& state, bool stuck);

/// Calls visit(begin, end) for parts of a stretch of a motion over which it is smooth.
template <class Visit>
void forSmoothPieces(const SolvedMotion& motion, double from, double to, const Visit& visit) {
  for (double begin = from; begin < to;) {
    const double smooth = motion.smoothUntil(begin);
    const double end = smooth > begin ? std::min(smooth, to) : to;
    visit(begin, end);
    begin = end;
  }
}

/// Follows a motion from t, where it holds, to t_end: visit(motion, from, to) for each piece, each
/// with an anchor of its own. Afterwards the motion holds at t_end. Throws StepTooLong.
template <class Visit>
void followSolved(const SolvedProblem& problem, double t, double t_end, double horizon,
                  SolvedMotion& motion, const Visit& visit) {
  constexpr int kMaxSegments = 1000000;
  for (int segments = 0; !(motion.validUntil() >= t_end); ++segments) {
    const double t_valid = motion.validUntil();
    if (motion.isClosed())
      throw StepTooLong(
          "it has turned 1e15 rad since its last event: attitude no longer known to 1e-4 rad");
    if (!(t_valid > t) || segments == kMaxSegments)
      throw StepTooLong(tooFastText(problem, motion.at(t), !(t_valid > t)));
    visit(motion, t, t_valid);
    motion.anchorAnew(problem, t_valid, motion.at(t_valid), horizon);
    t = t_valid;
  }
  visit(motion, t, t_end);
}

}  // namespace rigid_body_sim
