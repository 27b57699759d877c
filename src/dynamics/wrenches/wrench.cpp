#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

void applyForce(Wrench& wrench, const BodyState& state, const Vector3d& f_W, const Vector3d& r_W) {
  wrench.f_W += f_W;
  wrench.tau_W += ((r_W - state.x_W) - state.x_low_W).cross(f_W);
}

Vector3d toWorldAxes(const PointWrench& applied, const Vector3d& v,
                     const std::vector<BodyState>& bodies) {
  if (applied.axes == kWorld) return v;
  return rotate(bodies[applied.axes == kOwnBody ? applied.body : applied.axes].q_WP, v);
}

Vector3d armOf(const PointWrench& applied, const std::vector<BodyState>& bodies) {
  const BodyState& state = bodies[applied.body];
  if (applied.point_frame == kWorld) return (applied.point - state.x_W) - state.x_low_W;
  const bool own = applied.point_frame == applied.body || applied.point_frame == kOwnBody;
  if (own) return rotate(state.q_WP, applied.point);
  const BodyState& holder = bodies[applied.point_frame];
  const Vector3d arm_W = rotate(holder.q_WP, applied.point);
  return arm_W + ((holder.x_W - state.x_W) + (holder.x_low_W - state.x_low_W));
}

void addPointWrench(const PointWrench& applied, const std::vector<BodyState>& bodies,
                    Wrench& wrench) {
  const Vector3d f_W = toWorldAxes(applied, applied.force, bodies);
  wrench.f_W += f_W;
  wrench.tau_W += armOf(applied, bodies).cross(f_W) + toWorldAxes(applied, applied.torque, bodies);
}

}  // namespace rigid_body_sim
