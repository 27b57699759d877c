#pragma once

#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/state.hpp>
#include <rigid_body_sim/math/rotation.hpp>

#include "dynamics/contact/normal_law.hpp"

namespace rigid_body_sim {

/// How fast springs and dampers at points of a body make it swing and slow down: bounds on the
/// eigenvalues of Σ k j jᵀ and Σ c j jᵀ, with j what the velocity of the body, scaled so that its
/// mass and moments are one, moves a point by along a direction.
class Swings {
 public:
  Swings(const Body& body, const Quaterniond& q_WP)
      : root_mass_(1 / std::sqrt(body.mass)), root_I_(body.inv_I.cwiseSqrt()), q_WP_(q_WP) {
    stiffness_.setZero();
    damping_.setZero();
  }

  /// A spring and a damper along a direction, at an arm from the centre of mass.
  void addAt(const Vector3d& arm_W, const Vector3d& direction_W, const Bristle& spring) {
    Vector6 j;
    j << root_mass_ * direction_W, scaled(arm_W.cross(direction_W));
    add(j, spring);
  }

  /// A spring and a damper against turning about an axis.
  void addTurning(const Vector3d& axis_W, const Bristle& spring) {
    Vector6 j;
    j << Vector3d::Zero(), scaled(axis_W);
    add(j, spring);
  }

  /// [1/s²], [1/s]
  double frequencySquared() const { return greatest(stiffness_); }
  double decay() const { return greatest(damping_); }

  /// [s] The greatest damping of a spring, as a share of its stiffness.
  double slackness() const { return slackness_; }

  /// [1/s] The fastest motion of swings that add up. λ² + c λ + k = 0 holds for each, with c at
  /// most the slackness times k: where c² < 4 k, |λ| = √k, else 4/slackness <= |λ| <= c.
  static double fastest(double frequency_squared, double decay, double slackness) {
    const double frequency = std::sqrt(frequency_squared);
    return decay * slackness < 4 ? frequency : std::max(frequency, decay);
  }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  Vector3d scaled(const Vector3d& turn_W) const {
    return root_I_.cwiseProduct(rotateBack(q_WP_, turn_W));
  }
  void add(const Vector6& j, const Bristle& spring) {
    if (spring.damping > 0) slackness_ = std::max(slackness_, spring.damping / spring.stiffness);
    stiffness_ += (spring.stiffness * j) * j.transpose();
    damping_ += (spring.damping * j) * j.transpose();
  }
  /// (Σ λ⁸)^⅛ >= the greatest λ
  static double greatest(const Matrix6& m) {
    const double size = m.norm();  // so that powers do not leave the numbers
    if (!(size > 0)) return size;
    const Matrix6 square = (m / size) * (m / size);
    return size * std::sqrt(std::sqrt((square * square).eval().norm()));
  }

  double root_mass_;
  Vector3d root_I_;
  Quaterniond q_WP_;
  double slackness_ = 0;
  Matrix6 stiffness_, damping_;
};

}  // namespace rigid_body_sim
