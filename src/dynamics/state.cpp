#include <cmath>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

BodyState toBodyState(const Body& body, const BodyFrameMotion& motion) {
  BodyState state;
  const Vector3d origin_W = rotate(motion.q_WB, Vector3d(body.X_BP.translation()));
  state.x_W = motion.x_W + origin_W;
  state.x_low_W = origin_W - (state.x_W - motion.x_W);
  state.q_WP = product(motion.q_WB, body.q_BP);
  if (!body.pivoted) state.p_W = body.mass * (motion.v_W + motion.w_W.cross(origin_W));
  state.L_P = body.I.cwiseProduct(rotateBack(state.q_WP, motion.w_W));
  state.L_W = rotate(state.q_WP, state.L_P);
  return state;
}

BodyFrameMotion toBodyFrameMotion(const Body& body, const BodyState& state) {
  BodyFrameMotion motion;
  motion.q_WB = product(state.q_WP, Quaterniond(body.q_BP.conjugate()));
  const Vector3d origin_W = rotate(motion.q_WB, Vector3d(body.X_BP.translation()));
  motion.x_W = state.x_W + (state.x_low_W - origin_W);
  motion.w_W = rotate(state.q_WP, angularVelocity(body.inv_I, state.L_P));
  motion.v_W = state.p_W / body.mass - motion.w_W.cross(origin_W);
  return motion;
}

double distanceBetween(const BodyState& a, const BodyState& b) {
  return ((a.x_W - b.x_W) + (a.x_low_W - b.x_low_W)).norm();
}

Vector3d centerOfMass(const Body& body, const BodyState& state) {
  const Vector3d x_W = state.x_W + state.x_low_W;
  return body.pivoted ? Vector3d(x_W + rotate(state.q_WP, body.com_P)) : x_W;
}

Vector3d momentumOf(const Body& body, const BodyState& state) {
  if (!body.pivoted) return state.p_W;
  const Vector3d w_P = angularVelocity(body.inv_I, state.L_P);
  return body.mass * rotate(state.q_WP, Vector3d(w_P.cross(body.com_P)));
}

double radiusOfGyration(const Body& body) { return std::sqrt(body.I.maxCoeff() / body.mass); }

double kineticEnergy(const Body& body, const BodyState& state) {
  const double energy =
      0.5 * state.p_W.squaredNorm() / body.mass + 0.5 * state.L_P.cwiseAbs2().dot(body.inv_I);
  if (std::isfinite(energy)) return energy;
  // the squares may overflow where the energy does not
  return 0.5 * state.p_W.dot(state.p_W / body.mass) +
         0.5 * state.L_P.dot(state.L_P.cwiseProduct(body.inv_I));
}

}  // namespace rigid_body_sim
