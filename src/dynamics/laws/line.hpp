#pragma once

#include <array>
#include <cmath>

#include <rigid_body_sim/dynamics/spring.hpp>

/// The line between two ends along which springs and tethers pull.
namespace rigid_body_sim {

using LineEnds = std::array<Spring::End, 2>;

struct Line {
  Vector3d direction_W;  ///< unit, from the first end to the second; zero where they meet
  double length;         ///< [m]
  double rate;           ///< [m/s] of the length; zero where it is not asked for
};

/// Point of an end from the origin of P of its body; an end in the world has no arm.
inline Vector3d armOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return Vector3d::Zero();
  return rotate(at.states[end.body].q_WP, end.point);
}

/// What armOf counts from, in two parts of which the second is small.
inline std::array<Vector3d, 2> originOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return {end.point, Vector3d::Zero()};
  return {at.states[end.body].x_W, at.states[end.body].x_low_W};
}

inline Vector3d velocityOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return Vector3d::Zero();
  const Body& body = *at.bodies[end.body];
  const BodyState& s = at.states[end.body];
  const Vector3d w_P = angularVelocity(body.inv_I, s.L_P);
  return s.p_W / body.mass + rotate(s.q_WP, Vector3d(w_P.cross(end.point)));
}

/// [m] From the first end to the second. Origins are subtracted first: far from the world's origin,
/// the length keeps its digits.
inline Vector3d gapBetween(const LineEnds& ends, const ForceLaw::Bodies& at) {
  const std::array<Vector3d, 2> from = originOf(ends[0], at), to = originOf(ends[1], at);
  return (to[0] - from[0]) + (to[1] - from[1]) + (armOf(ends[1], at) - armOf(ends[0], at));
}

inline Line lineBetween(const LineEnds& ends, const ForceLaw::Bodies& at, bool with_rate) {
  const Vector3d d = gapBetween(ends, at);
  Line line{Vector3d::Zero(), d.norm(), 0};
  if (!(line.length > 0)) return line;
  line.direction_W = d / line.length;
  if (with_rate)
    line.rate = line.direction_W.dot(velocityOf(ends[1], at) - velocityOf(ends[0], at));
  return line;
}

/// Adds the wrenches of a tension [N] along the line.
inline void addTension(const LineEnds& ends, const Line& line, double tension,
                       const ForceLaw::Bodies& at, std::vector<Wrench>& wrenches) {
  for (std::size_t k = 0; k < 2; ++k) {
    const Spring::End& end = ends[k];
    if (end.body == kWorld) continue;
    const Vector3d f_W = (k == 0 ? tension : -tension) * line.direction_W;
    wrenches[end.body].f_W += f_W;
    wrenches[end.body].tau_P += end.point.cross(rotateBack(at.states[end.body].q_WP, f_W));
  }
}

/// Throws std::invalid_argument for ends on one body, and for points that are not finite.
void checkEnds(const char* law, const LineEnds& ends);

/// Indices of the bodies at the ends.
std::vector<std::size_t> membersOf(const LineEnds& ends);

/// The ends where the body of index i has index index(i).
LineEnds reindexedEnds(LineEnds ends, const std::function<std::size_t(std::size_t)>& index);

/// The ends where what is fixed to a body is given in another frame N of it.
LineEnds reframedEnds(LineEnds ends, std::size_t body, const Isometry3d& X_NP);

/// [m] The length of the line, and those of the arms of its ends; see ForceLaw::reach.
double reachOf(const LineEnds& ends, const ForceLaw::Bodies& at);

/// Adds what a spring and a damper along the line bring about; see ForceLaw::addStiffness.
void addStiffnessOf(const LineEnds& ends, double stiffness, double damping,
                    const std::vector<const Body*>& bodies, std::vector<Stiffness>& sums);

}  // namespace rigid_body_sim
