#pragma once

#include <cstddef>

#include "dynamics/taylor/taylor_drive.hpp"
#include "dynamics/taylor/taylor_equations.hpp"

/// The recursion from each coefficient of the Taylor series to the next, and the evaluation of the
/// series: what a segment spends its time in. Four lanes wide, of which vectors use three.
namespace rigid_body_sim {

/// The values of the series less their constant terms.
template <class T>
struct TaylorIncrements {
  T w[4], q[4], squares[4], crosses[4], turns[4];
  /// Of the integrals of squares, crosses and turns over the time of the series.
  struct Integrals {
    T squares[4], crosses[4], turns[4];
  } integrals;
};

/// Which of them are wanted: those of the products of q, and their integrals.
enum class TaylorGains { kMotion, kProducts, kIntegrals };

/// Fills in the coefficients 1 to `degree` from those of degree 0, the equations in the same unit
/// of time as the series:
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

/// The same with a drive, turned, and the drive's impulse and twist.
template <class T>
void expandDriven(const TaylorEquations<T>& equations, TaylorDrive<T>& drive, std::size_t degree,
                  TaylorSeries<T>& series);

/// The series at time s, by Horner's rule.
template <class T>
void evaluateTaylor(const TaylorSeries<T>& series, TaylorGains wanted, std::size_t degree, T s,
                    TaylorIncrements<T>& increments);

}  // namespace rigid_body_sim
