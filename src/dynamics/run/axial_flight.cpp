#include "dynamics/run/axial_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <rigid_body_sim/math/rotation.hpp>

#include "dynamics/rotation/free_motion.hpp"
#include "dynamics/rotation/rotation_state.hpp"

namespace rigid_body_sim {
namespace {

/// Whether a body that turns about the axis, but for rounding, goes on so: its moment is the least
/// or the greatest one, and well apart from the others.
bool holdsItsAxis(const Vector3d& I, int axis) {
  const double one = I(axis) - I((axis + 1) % 3), other = I(axis) - I((axis + 2) % 3);
  return std::min(std::abs(one), std::abs(other)) > 0.01 * I(axis) && (one > 0) == (other > 0);
}

bool liesAlong(int axis, const Vector3d& v, double tolerance) {
  const double across = std::max(std::abs(v((axis + 1) % 3)), std::abs(v((axis + 2) % 3)));
  return across <= tolerance * std::abs(v(axis));
}

/// Whether nothing acts but forces fixed in the world at the centre of mass, and couples.
bool isCouple(const HeldWrench& wrench) {
  return wrench.f_P.isZero(0) && wrench.body_point_forces.empty() &&
         wrench.world_point_forces.empty() && !wrench.drive && !wrench.medium;
}

}  // namespace

std::optional<AxialFlight> AxialFlight::of(const Body& body, const HeldWrench& wrench,
                                           const Vector3d& g_W, const BodyState& start) {
  if (!isCouple(wrench)) return std::nullopt;
  const Vector3d torque_P = wrench.tau_P + rotateBack(start.q_WP, wrench.tau_W);
  int axis = 0;
  torque_P.cwiseAbs().maxCoeff(&axis);
  // what the rounding of a turned velocity or torque leaves
  const double tolerance =
      holdsItsAxis(body.I, axis) ? 4 * std::numeric_limits<double>::epsilon() : 0;
  if (!liesAlong(axis, torque_P, tolerance) || !liesAlong(axis, start.L_P, tolerance))
    return std::nullopt;
  AxialFlight flight;
  flight.start_ = start;
  flight.f_W_ = wrench.f_W + body.mass * g_W;
  flight.torque_W_ = wrench.tau_W + rotate(start.q_WP, wrench.tau_P);
  flight.torque_ = torque_P(axis);
  flight.mass_ = body.mass;
  flight.axis_ = axis;
  const Wide<double> I(body.I(axis));
  flight.rate_ = Wide<double>(start.L_P(axis)) / I;
  flight.acceleration_ = Wide<double>(flight.torque_) / I;
  return flight;
}

double AxialFlight::timeToTurn(double angle) const {
  const double w = std::abs(static_cast<double>(rate_));
  const double a = std::abs(static_cast<double>(acceleration_));
  return 2 * angle / (w + std::sqrt(w * w + 2 * a * angle));
}

BodyState AxialFlight::at(double dt) const {
  BodyState state = start_;
  moveBy(Vector3d(dt / mass_ * (start_.p_W + 0.5 * dt * f_W_)), state);
  state.p_W += dt * f_W_;
  state.L_W += dt * torque_W_;
  state.L_P(axis_) += dt * torque_;
  const Wide<double> t(dt);
  const Wide<double> angle = t * (rate_ + t * acceleration_ / Wide<double>(2));
  state.q_WP = product(start_.q_WP, rotationAbout<double>(Vector3d::Unit(axis_), angle));
  renormalize(state.q_WP);
  return state;
}

}  // namespace rigid_body_sim
