#pragma once

#include <array>

#include <rigid_body_sim/math/types.hpp>

#include "dynamics/laws/medium_load.hpp"
#include "dynamics/taylor/taylor_equations.hpp"
#include "dynamics/taylor/taylor_terms.hpp"

namespace rigid_body_sim {

/// The equations of a body in a medium under held wrenches, constant in the world or in the body.
struct MediumEquations {
  Vector3d I, inv_I;  ///< [kg m²], [1/(kg m²)]
  double inv_mass;    ///< [1/kg]
  MediumLoad load;
  Vector3d a_W = Vector3d::Zero();      ///< [m/s²] of gravity and all forces fixed in the world
  Vector3d f_P = Vector3d::Zero();      ///< [N] fixed in the body
  Vector3d tau_W = Vector3d::Zero();    ///< [N m] fixed in the world
  Vector3d tau_P = Vector3d::Zero();    ///< [N m] fixed in the body
  Matrix3d moments = Matrix3d::Zero();  ///< [N m] Σ arm_P force_Wᵀ of body points
  Vector3d pull_W = Vector3d::Zero();   ///< [N] sum of the forces at points of the world
  double rate = 1;                      ///< [1/s] the unit of time is 1/rate
  double speed_unit = 1;  ///< [m/s] power of two near the speed, in which a speed of 1e-160 m/s has
                          ///< a square, too
  bool drops_quadratic = false;  ///< quadratic drag, alike in all directions, is left out
};

/// Coefficients by degree in units of time 1/rate; those of degree 0 of w, q, v and axes are where
/// it starts from.
struct MediumSeries {
  static constexpr std::size_t kDegree = kHighestTaylorDegree;
  template <class Value>
  using Of = std::array<Value, kDegree + 1>;

  Of<Vector3d> w;         ///< [rad/s] angular velocity, principal axes
  Of<Eigen::Vector4d> q;  ///< attitude (x, y, z, w)
  Of<Matrix3d> axes;      ///< Rᵀ
  Of<Vector3d> v;         ///< [m/s] of the centre of mass through the medium, world axes
  Of<Vector3d> x;         ///< [m] displacement, world axes
  Of<Vector3d> twist;     ///< [N m s] what L_W gains
  Of<Vector3d> u;         ///< [m/s] of the centre of drag through the medium: world axes where drag
                          ///< is of translation, else the axes of the drag; one degree less
  Vector3d signs = Vector3d::Zero();  ///< of the components of u, right after the start
};

/// |u|: norm(), to the bit, wherever u has a square.
inline double speedOf(const Vector3d& u) {
  const double unit = unitOf(u.cwiseAbs().maxCoeff());
  return unit * (u / unit).norm();
}

/// The coefficients from degree 1 on.
void expandMedium(const MediumEquations& equations, MediumSeries& series);

}  // namespace rigid_body_sim
