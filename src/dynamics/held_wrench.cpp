#include <rigid_body_sim/dynamics/held_wrench.hpp>

namespace rigid_body_sim {
namespace {

/// Levers summed into one per world axis:  Σ armᵢ × Rᵀ fᵢ = Σ_k (Σᵢ armᵢ f_ik) × Rᵀ e_k.
std::vector<HeldWrench::Lever> mergedLevers(const std::vector<HeldWrench::Lever>& levers) {
  Matrix3d moments = Matrix3d::Zero();
  for (const HeldWrench::Lever& lever : levers) moments += lever.arm_P * lever.force_W.transpose();
  std::vector<HeldWrench::Lever> merged;
  for (int k = 0; k < 3; ++k) merged.push_back({moments.col(k), Vector3d::Unit(k)});
  return merged;
}

}  // namespace

bool HeldWrench::holds(const PointWrench& applied) {
  const bool own_axes = applied.axes == applied.body;
  const bool own_point = applied.point_frame == applied.body;
  if (own_axes) return own_point;
  return applied.axes == kWorld && (own_point || applied.point_frame == kWorld);
}

void HeldWrench::add(const PointWrench& applied) {
  if (applied.axes == applied.body) {
    f_P += applied.force;
    tau_P += applied.point.cross(applied.force) + applied.torque;
    return;
  }
  f_W += applied.force;
  tau_W += applied.torque;
  if (applied.force.isZero(0)) return;
  if (applied.point_frame == kWorld) {
    pulls.push_back({applied.point, applied.force});
  } else if (!applied.point.isZero(0)) {
    levers.push_back({applied.point, applied.force});
    if (levers.size() > 3) levers = mergedLevers(levers);
  }
}

Wrench HeldWrench::at(const BodyState& state) const {
  Wrench wrench;
  wrench.f_W = f_W + rotate(state.q_WP, f_P);
  wrench.tau_W = tau_W;
  wrench.tau_P = tau_P;
  for (const Lever& lever : levers)
    wrench.tau_P += lever.arm_P.cross(rotateBack(state.q_WP, lever.force_W));
  for (const Pull& pull : pulls)
    wrench.tau_W += ((pull.point_W - state.x_W) - state.x_low_W).cross(pull.force_W);
  return wrench;
}

bool HeldWrench::torqueFree() const {
  return f_P.isZero(0) && tau_W.isZero(0) && tau_P.isZero(0) && levers.empty() && pulls.empty();
}

}  // namespace rigid_body_sim
