#pragma once

#include <functional>

#include <rigid_body_sim/mass/mass_properties.hpp>

#include "support/reference_motion.hpp"

/// An independent reference of a body on a pivot: Newton's and Euler's equations about the centre
/// of mass, with the force of the pivot as an unknown, and neither an inertia about the pivot nor
/// principal axes.
namespace rigid_body_sim::reference {

/// What acts on the body but for its pivot, gravity included, at its centre of mass, axes of B.
struct LoadAtCom {
  Vector f = Vector::Zero();
  Vector tau = Vector::Zero();

  /// Adds a force at a point, from the centre of mass.
  void add(const Vector& force, const Vector& arm) {
    f += force;
    tau += arm.cross(force);
  }
};

struct PivotedBody {
  MassProperties mass;  ///< in B
  Vector3d point_B;
  std::function<LoadAtCom(const Motion&)> load;  ///< at an attitude q_WB and angular velocity ω_B
};

struct PivotSolution {
  Vector w_dot_B;
  Vector force_B;  ///< [N] of the pivot on the body
};

/// With c from the point to the centre of mass and J the inertia about the latter:
///   m (ω' × c + ω × (ω × c)) − r = f,   J ω' + ω × J ω + c × r = τ
inline PivotSolution solve(const PivotedBody& body, const Motion& m) {
  const LoadAtCom load = body.load(m);
  const Vector c = (body.mass.com_B - body.point_B).cast<Real>();
  const Matrix J = body.mass.I_Bcm.cast<Real>();
  Matrix c_hat;
  c_hat << 0, -c.z(), c.y(), c.z(), 0, -c.x(), -c.y(), c.x(), 0;
  Eigen::Matrix<Real, 6, 6> A;
  A << -Real(body.mass.mass) * c_hat, -Matrix::Identity(), J, c_hat;
  Eigen::Matrix<Real, 6, 1> b;
  b << load.f - Real(body.mass.mass) * m.w.cross(m.w.cross(c)), load.tau - m.w.cross(J * m.w);
  const Eigen::Matrix<Real, 6, 1> x = A.fullPivLu().solve(b);
  return {x.head<3>(), x.tail<3>()};
}

/// The rotation of B a duration later; m.q is q_WB and m.w is ω_B.
inline Motion advancePivoted(const PivotedBody& body, const Motion& m, Real duration) {
  Body unit;  // of inertia 1, so that its torque is ω'
  unit.mass = 1;
  unit.I = Vector3d::Ones();
  const auto acceleration = [&](Real, const Motion& now) {
    Load load;
    load.tau_P = solve(body, now).w_dot_B;
    return load;
  };
  return advance(unit, acceleration, m, 0, duration, 0.05L);
}

}  // namespace rigid_body_sim::reference
