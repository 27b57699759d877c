#pragma once

#include <memory>
#include <variant>

#include "dynamics/rotation/free_flight.hpp"
#include "dynamics/taylor/taylor_segment.hpp"

namespace rigid_body_sim {

/// The motion of one body under wrenches that are constant in the world or in the body, solved from
/// an anchor on: a free flight where there is no torque, else a Taylor segment.
class SolvedMotion {
 public:
  /// Anchors the motion at a state of time t [s]; it is not asked for beyond t + horizon.
  SolvedMotion(const Body& body, const HeldWrench& wrench, const Vector3d& g_W, double t,
               const BodyState& state, double horizon, const ErrorBound& bound = {});

  /// Anchors the motion at another state, as if made anew. What copies of it tell stays.
  void anchorAnew(const Body& body, const HeldWrench& wrench, const Vector3d& g_W, double t,
                  const BodyState& state, double horizon, const ErrorBound& bound);

  /// [s] the time up to which the solution holds; NaN where the motion is not finite.
  double validUntil() const { return valid_until_; }

  /// [s] the time up to which, moreover, all of it is finite for certain, by one of its states; the
  /// anchor where the numbers are so large that only evaluation tells.
  double finiteUntil(const BodyState& state) const;

  /// Whether the body turns freely: then another anchor at validUntil() would not help it.
  bool isFree() const { return std::holds_alternative<FreeFlight>(motion_); }

  /// The state at a time [s] between the anchor and validUntil().
  BodyState at(double t) const;

 private:
  using TaylorPointer = std::shared_ptr<TaylorSegment>;  // changed only while no copy shares it

  double anchor_;
  double valid_until_;
  bool modest_;  // whether body and wrench are far from what overflows
  std::variant<FreeFlight, TaylorPointer> motion_;
};

}  // namespace rigid_body_sim
