#pragma once

#include <optional>

#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/medium/linear_translation.hpp"
#include "dynamics/medium/medium_series.hpp"
#include "dynamics/taylor/taylor_segment.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// A TaylorSegment of a body in a medium: HeldWrench::medium must be there. It ends where a
/// component of the velocity along an axis of quadratic drag changes its sign. Where the
/// translation goes by itself, linearly, it is a closed form, and the series are of the rotation.
/// Its length does not depend on what is to come.
class MediumSegment {
 public:
  MediumSegment(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                const BodyState& start, const ErrorBound& bound = {});

  void startAnew(const HeldWrench& same_wrench, const BodyState& start);

  const BodyState& start() const { return start_; }

  /// [s] The duration for which the series holds to the bound.
  double validFor() const { return valid_for_; }

  /// [s] For how long from dt on, within validFor(), seven Gauss-Legendre nodes see all that
  /// happens.
  double smoothFor(double dt) const;

  /// The state at a time [s] from 0 to validFor() after the start.
  BodyState at(double dt) const;

 private:
  void takeTranslationOut(const HeldWrench& wrench);
  void setUpPulls(const HeldWrench& wrench);
  void stopWhatDecayed();
  void setUpRate();
  double speedBound(double acceleration) const;
  double length(double precision) const;
  double smallLength(double longest) const;
  double firstSignChange(double longest) const;
  double signChange(int axis, double end, double none) const;
  double lowest(int axis, double before, double after) const;
  double through(double s, int axis) const;
  double throughRate(double s, int axis) const;

  MediumEquations equations_;
  Vector3d tau_W_;  // [N m] of the wrench, without its forces at points of the world
  ErrorBound bound_;
  BodyState start_;
  double fastest_ = 0;  // [1/s] what changes the motion fastest at the start
  double kink_ = 0;     // [s] for which u cannot have come halfway to zero, where |u| has a kink
  double small_speed_ = 0;  // [m/s] up to which quadratic drag is left out, where it is
  MediumSeries series_;
  std::optional<LinearTranslation> translation_;  // where it is a closed form
  double valid_for_ = 0;
};

}  // namespace rigid_body_sim
