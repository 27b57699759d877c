#include <cmath>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

BodyState toBodyState(const Body& body, const BodyFrameMotion& motion) {
  BodyState state;
  const Vector3d com_W = rotate(motion.q_WB, Vector3d(body.X_BP.translation()));
  state.x_W = motion.x_W + com_W;
  state.x_low_W = com_W - (state.x_W - motion.x_W);
  state.q_WP = product(motion.q_WB, body.q_BP);
  state.p_W = body.mass * (motion.v_W + motion.w_W.cross(com_W));
  state.L_P = body.I.cwiseProduct(rotateBack(state.q_WP, motion.w_W));
  state.L_W = rotate(state.q_WP, state.L_P);
  return state;
}

BodyFrameMotion toBodyFrameMotion(const Body& body, const BodyState& state) {
  BodyFrameMotion motion;
  motion.q_WB = product(state.q_WP, Quaterniond(body.q_BP.conjugate()));
  const Vector3d com_W = rotate(motion.q_WB, Vector3d(body.X_BP.translation()));
  motion.x_W = state.x_W + (state.x_low_W - com_W);
  motion.w_W = rotate(state.q_WP, angularVelocity(body.inv_I, state.L_P));
  motion.v_W = state.p_W / body.mass - motion.w_W.cross(com_W);
  return motion;
}

double distanceBetween(const BodyState& a, const BodyState& b) {
  return ((a.x_W - b.x_W) + (a.x_low_W - b.x_low_W)).norm();
}

double radiusOfGyration(const Body& body) { return std::sqrt(body.I.maxCoeff() / body.mass); }

double kineticEnergy(const Body& body, const BodyState& state) {
  return 0.5 * state.p_W.squaredNorm() / body.mass + 0.5 * state.L_P.cwiseAbs2().dot(body.inv_I);
}

}  // namespace rigid_body_sim
