#pragma once

#include <cstddef>

#include <rigid_body_sim/dynamics/taylor_segment.hpp>

/// The recursion from each coefficient of the Taylor series to the next, and the evaluation of the
/// series: what a segment spends its time in. Four lanes wide, of which vectors use three.
namespace rigid_body_sim {

/// The torque about the centre of mass of forces that act at points of the world, beyond what it is
/// at the start: force_W × the displacement of the body, in the unit of time in which the series
/// are.
template <class T>
struct TaylorPull {
  T force_W[3];         ///< the sum of the forces
  T linear_W[3];        ///< force_W × velocity at the start
  T quadratic_W[3];     ///< force_W × constant acceleration / 2
  T acceleration_P[3];  ///< of the force that is fixed in the body
  T inv_I[3];
};

/// What the recursion starts from, in the unit of time in which the series are.
template <class T>
struct TaylorEquations {
  T gyroscopic[4];  ///< (I₂ − I₃)/I₁ and cyclic: ω₁' = gyroscopic₁ ω₂ ω₃ + …
  T steady[4];      ///< the part of ω' that the attitude does not change
  T turning[9][4];  ///< I⁻¹ × the torque that comes with each product of components of q:
                    ///< xx, yy, zz, xy, yz, zx, wx, wy, wz
  const TaylorPull<T>* pull = nullptr;  ///< null: no forces act at points of the world
};

/// The values of the series less their constant terms.
template <class T>
struct TaylorIncrements {
  T w[4], q[4], squares[4], crosses[4], turns[4];
};

/// Fills in the coefficients 1 to `degree` from those of degree 0:
///   ω' = gyroscopic ω ω + steady + turning · (products of q),   q' = ½ q (0, ω)
/// turned: whether the products are wanted; if not, turning and steady count as zero.
/// The processor's widest lanes are used; the result is the same to the last bit.
template <class T>
void expandTaylor(const TaylorEquations<T>& equations, bool turned, std::size_t degree,
                  TaylorSeries<T>& series);

/// The same with no more than the lanes that every processor has.
template <class T>
void expandTaylorNarrow(const TaylorEquations<T>& equations, bool turned, std::size_t degree,
                        TaylorSeries<T>& series);

/// The series at time s, by Horner's rule; of the products only if turned.
template <class T>
void evaluateTaylor(const TaylorSeries<T>& series, bool turned, std::size_t degree, T s,
                    TaylorIncrements<T>& increments);

}  // namespace rigid_body_sim
