#include "dynamics/rotation/free_flight.hpp"

#include "dynamics/rotation/free_motion.hpp"

namespace rigid_body_sim {

BodyState flownFreely(const Body& body, const BodyState& start, double dt) {
  BodyState state = start;
  driftPosition(body.mass, dt, state);
  const RotationState<double> rotation =
      FreeTop<double>(body.I).after(dt, start.q_WP, start.L_P, start.L_W);
  state.q_WP = rotation.q_WP;
  state.L_P = rotation.L_P;
  return state;
}

FreeFlight::FreeFlight(const Body& body, const Vector3d& f_W, const BodyState& start,
                       bool read_once)
    : start_(start),
      f_W_(f_W),
      mass_(body.mass),
      rotation_(FreeTop<double>(body.I).from(start.q_WP, start.L_P, start.L_W, read_once)) {}

BodyState FreeFlight::at(double dt) const {
  BodyState state = start_;
  moveBy(Vector3d(dt / mass_ * (start_.p_W + 0.5 * dt * f_W_)), state);
  state.p_W += dt * f_W_;
  const RotationState<double> rotation = rotation_.at(dt);
  state.q_WP = rotation.q_WP;
  state.L_P = rotation.L_P;
  return state;
}

}  // namespace rigid_body_sim
