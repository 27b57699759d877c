#pragma once

#include <rigid_body_sim/dynamics/state.hpp>
#include <rigid_body_sim/math/types.hpp>

#include "support/worlds.hpp"

/// A scene as a whole at another place: mirrored in the plane y = 0 or not, then turned and moved.
namespace rigid_body_sim::test {

struct Placement {
  Isometry3d motion = Isometry3d::Identity();
  bool mirrored = false;

  static Vector3d mirror(const Vector3d& v) { return {v.x(), -v.y(), v.z()}; }

  /// A point and a vector in the body frame, a frame in it, and an angular velocity or momentum.
  Vector3d inBody(const Vector3d& p) const { return mirrored ? mirror(p) : p; }
  Vector3d spinInBody(const Vector3d& w) const { return mirrored ? -mirror(w) : w; }
  Matrix3d inBody(const Matrix3d& R) const {
    const Matrix3d M = Vector3d(1, -1, 1).asDiagonal();
    return mirrored ? Matrix3d(M * R * M) : R;
  }

  /// The same in the world.
  Vector3d point(const Vector3d& p) const { return motion * inBody(p); }
  Vector3d vector(const Vector3d& v) const { return motion.linear() * inBody(v); }
  Vector3d spin(const Vector3d& w) const { return motion.linear() * spinInBody(w); }
  Quaterniond attitude(const Quaterniond& q) const {
    const Vector3d axis = spinInBody(q.vec());  // a vector that a mirror turns as a spin
    return Quaterniond(motion.linear()) * Quaterniond(q.w(), axis.x(), axis.y(), axis.z());
  }

  BodyState state(BodyState s) const {
    s.x_W = point(s.x_W);
    s.q_WP = attitude(s.q_WP);
    s.p_W = vector(s.p_W);
    s.L_W = spin(s.L_W);
    s.L_P = spinInBody(s.L_P);
    return s;
  }
};

/// Here; turned and moved; mirrored too.
inline std::vector<Placement> everyPlacement() {
  Placement there;
  there.motion.linear() = Quaterniond(0.5, -0.1, 0.7, 0.3).normalized().toRotationMatrix();
  there.motion.translation() = Vector3d(3, -5, 2);
  Placement mirrored, mirrored_there = there;
  mirrored.mirrored = mirrored_there.mirrored = true;
  return {there, mirrored, mirrored_there};
}

}  // namespace rigid_body_sim::test
