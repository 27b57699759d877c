#include "ros/mouse/mouse_spring.hpp"

#include <algorithm>

namespace rigid_body_sim {
namespace {

constexpr double kStiffest = 10;        // [rad/s] as in MuJoCo, whose mouse spring has 100 N/m a kg
constexpr double kLeastMobility = 0.1;  // at a pivot, which no force moves: of that of a free body
constexpr double kTurnPerStep = 0.2;    // [rad]

}  // namespace

double massAtPoint(const Body& body, const Vector3d& r_P) {
  const Vector3d lever_squared =
      Vector3d::Constant(r_P.squaredNorm()) - r_P.cwiseProduct(r_P);  // about each axis
  const double by_place = body.pivoted ? 0 : 3 / body.mass;
  const double mobility = by_place + lever_squared.dot(body.inv_I);
  return 3 / std::max(mobility, kLeastMobility * 3 / body.mass);
}

PointWrench pullOf(const MouseSpring& spring, const Body& body, const BodyState& state, double h) {
  const Vector3d w_P = angularVelocity(body.inv_I, state.L_P);
  const Vector3d arm_W = rotate(state.q_WP, spring.point_P);
  const Vector3d stretch_W = ((spring.goal_W - state.x_W) - state.x_low_W) - arm_W;
  const Vector3d v_W =
      state.p_W / body.mass + rotate(state.q_WP, Vector3d(w_P.cross(spring.point_P)));
  const double m = massAtPoint(body, spring.point_P);
  const double w = std::min(kStiffest, kTurnPerStep / h);

  PointWrench pull;
  pull.body = pull.point_frame = spring.body;
  pull.point = spring.point_P;
  pull.force = m * w * (w * stretch_W - 2 * v_W);
  return pull;
}

}  // namespace rigid_body_sim
