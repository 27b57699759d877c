#pragma once

#include <cstddef>

/// The equations of a TaylorSegment and the series that solve them, as plain numbers, four lanes
/// each, of which vectors use three.
namespace rigid_body_sim {

/// The highest degree of the series: from 18 on, what longer segments save is about what each
/// costs more.
constexpr std::size_t kHighestTaylorDegree = 20;

/// Coefficients by degree, up to the highest.
template <class T>
struct TaylorSeries {
  using Coefficients = T[kHighestTaylorDegree + 1][4];
  Coefficients w;        ///< angular velocity, principal axes
  Coefficients q;        ///< attitude (x, y, z, w)
  Coefficients squares;  ///< time integral of (xx, yy, zz), from degree 1 on
  Coefficients crosses;  ///< of (xy, yz, zx)
  Coefficients turns;    ///< of (wx, wy, wz)
  Coefficients pull;     ///< of the torque of a TaylorPull, world axes
};

/// The torque about the centre of mass of forces that act at points of the world, beyond what it is
/// at the start: force_W × the displacement of the body.
template <class T>
struct TaylorPull {
  T force_W[3];         ///< the sum of the forces
  T linear_W[3];        ///< force_W × velocity at the start
  T quadratic_W[3];     ///< force_W × constant acceleration / 2
  T acceleration_P[3];  ///< of the force that is fixed in the body
  T inv_I[3];
};

/// What the recursion starts from: ω' = gyroscopic ω ω + steady + turning · (products of q) + …
template <class T>
struct TaylorEquations {
  T gyroscopic[4];    ///< (I₂ − I₃)/I₁ and cyclic: ω₁' = gyroscopic₁ ω₂ ω₃
  T steady[4];        ///< the part of ω' that the attitude does not change
  T turning[9][4];    ///< I⁻¹ × the torque that comes with each product of components of q:
                      ///< xx, yy, zz, xy, yz, zx, wx, wy, wz
  bool turns = true;  ///< false: all of `turning` is zero
  const TaylorPull<T>* pull = nullptr;  ///< null: no forces act at points of the world
};

}  // namespace rigid_body_sim
