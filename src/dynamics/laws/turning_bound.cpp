#include "dynamics/laws/turning_bound.hpp"

#include <cmath>

namespace rigid_body_sim {

double turningBound(const Body& body, const BodyState& state, double torque, double duration) {
  const Vector3d w_P = angularVelocity(body.inv_I, state.L_P);
  const double slowest = 1 / body.inv_I.maxCoeff();  // the least moment
  const double energy2 = w_P.dot(state.L_P);
  double w2 = std::min(energy2 / slowest, (state.L_P / slowest).squaredNorm());
  if (torque > 0) {
    const double w = (state.L_P.norm() + torque * duration) / slowest;
    w2 = w * w;
  }
  const Vector3d& I = body.I;
  const double skew = std::max(
      {std::abs(I[1] - I[2]) / I[0], std::abs(I[2] - I[0]) / I[1], std::abs(I[0] - I[1]) / I[2]});
  return w2 + 0.5 * w2 * skew + torque / slowest;
}

}  // namespace rigid_body_sim
