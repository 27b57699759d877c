#pragma once

#include <optional>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/wrenches/held_wrench.hpp"
#include "math/wide.hpp"

namespace rigid_body_sim {

/// The motion of a body that turns about a principal axis under a steady torque along that axis,
/// and a constant force fixed in the world, from a start on: the axis stays where it is, and with
/// L = L₀ + τ t about it the body turns by
///   θ = (L₀ t + τ t²/2)/I.
/// Any time is one evaluation, however fast the body has come to turn.
class AxialFlight {
 public:
  /// g_W [m/s²]: uniform gravity. start.q_WP must be a unit quaternion. None where the body does
  /// not turn about a principal axis, but for rounding, or something else than this acts on it.
  static std::optional<AxialFlight> of(const Body& body, const HeldWrench& wrench,
                                       const Vector3d& g_W, const BodyState& start);

  const BodyState& start() const { return start_; }

  /// [s] How long after its start it has turned by that angle [rad] at most.
  double timeToTurn(double angle) const;

  /// The state dt [s] after the start.
  BodyState at(double dt) const;

 private:
  AxialFlight() = default;

  BodyState start_;
  Vector3d f_W_;       // [N] with gravity
  Vector3d torque_W_;  // [N m]
  double torque_ = 0;  // [N m] about the axis
  double mass_ = 0;
  int axis_ = 0;               // of the principal axes
  Wide<double> rate_;          // [rad/s] at the start
  Wide<double> acceleration_;  // [rad/s²]
};

}  // namespace rigid_body_sim
