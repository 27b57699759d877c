#include "dynamics/methods/state_dot.hpp"

#include "dynamics/rotation/free_motion.hpp"

namespace rigid_body_sim {

BodyStateDot stateDot(const Body& body, const BodyState& state, const Wrench& wrench) {
  const Vector3d w_P = angularVelocity(body.inv_I, state.L_P);
  const Quaterniond half_w(0, 0.5 * w_P.x(), 0.5 * w_P.y(), 0.5 * w_P.z());
  BodyStateDot dot;
  dot.x_dot_W = state.p_W / body.mass;
  const Quaterniond q_dot = product(state.q_WP, half_w);
  dot.q_dot = {q_dot.x(), q_dot.y(), q_dot.z(), q_dot.w()};  // in registers
  dot.p_dot_W = wrench.f_W;
  const Triple<double> differences{body.I[1] - body.I[2], body.I[2] - body.I[0],
                                   body.I[0] - body.I[1]};
  dot.L_dot_P = vectorOf(gyroscopicTorque(differences, tripleOf(w_P))) +
                rotateBack(state.q_WP, wrench.tau_W) + wrench.tau_P;
  return dot;
}

BodyState stagePoint(const BodyState& state, const BodyStateDot& dot, double h) {
  BodyState next = state;
  next.x_low_W += h * dot.x_dot_W;
  next.q_WP.coeffs() += h * dot.q_dot;
  next.p_W += h * dot.p_dot_W;
  next.L_P += h * dot.L_dot_P;
  return next;
}

BodyState stepEnd(const BodyState& state, const BodyStateDot& dot, double h) {
  BodyState next = stagePoint(state, dot, h);
  next.x_low_W = state.x_low_W;
  moveBy(Vector3d(h * dot.x_dot_W), next);
  next.q_WP.normalize();
  next.L_W = rotate(next.q_WP, next.L_P);
  return next;
}

}  // namespace rigid_body_sim
