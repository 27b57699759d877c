#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

void applyForce(Wrench& wrench, const BodyState& state, const Vector3d& f_W, const Vector3d& r_W) {
  wrench.f_W += f_W;
  wrench.tau_W += ((r_W - state.x_W) - state.x_low_W).cross(f_W);
}

bool isCoupled(const PointWrench& applied) {
  const auto foreign = [&](std::size_t frame) { return frame != kWorld && frame != applied.body; };
  return foreign(applied.axes) || foreign(applied.point_frame);
}

void addPointWrench(const PointWrench& applied, const std::vector<BodyState>& bodies,
                    Wrench& wrench) {
  const auto turnToWorld = [&](const Vector3d& v) {
    return applied.axes == kWorld ? v : rotate(bodies[applied.axes].q_WP, v);
  };
  const BodyState& state = bodies[applied.body];
  const Vector3d f_W = turnToWorld(applied.force);
  Vector3d arm_W;
  if (applied.point_frame == kWorld) {
    arm_W = (applied.point - state.x_W) - state.x_low_W;
  } else {
    const BodyState& holder = bodies[applied.point_frame];
    arm_W = rotate(holder.q_WP, applied.point);
    if (applied.point_frame != applied.body)
      arm_W += (holder.x_W - state.x_W) + (holder.x_low_W - state.x_low_W);
  }
  wrench.f_W += f_W;
  wrench.tau_W += arm_W.cross(f_W) + turnToWorld(applied.torque);
}

}  // namespace rigid_body_sim
