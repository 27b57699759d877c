#pragma once

#include "math/always_inline.hpp"

/// Sine and cosine of small angles by polynomials: the same operations on a number and on a pack of
/// them, so that the bits depend neither on the width nor on the C library.
/// Source: minimax coefficients of FreeBSD's msun, k_sin.c and k_cos.c (Sun Microsystems, 1993).
namespace rigid_body_sim {

/// (π/4)², the largest square of an angle [rad²] for which sinOverAngle and cosine hold.
constexpr double kSmallAngleSquared = 0.61685027506808491;

/// sin(x)/x of x = √square, to 1 ulp.
template <class T>
RIGID_BODY_SIM_INLINE T sinOverAngle(const T& square) {
  constexpr double s1 = -1.66666666666666324348e-01, s2 = 8.33333333332248946124e-03,
                   s3 = -1.98412698298579493134e-04, s4 = 2.75573137070700676789e-06,
                   s5 = -2.50507602534068634195e-08, s6 = 1.58969099521155010221e-10;
  return 1.0 +
         square *
             (s1 + square * (s2 + square * (s3 + square * (s4 + square * (s5 + square * s6)))));
}

/// cos(x) of x = √square, to 1 ulp.
template <class T>
RIGID_BODY_SIM_INLINE T cosine(const T& square) {
  constexpr double c1 = 4.16666666666666019037e-02, c2 = -1.38888888888741095749e-03,
                   c3 = 2.48015872894767294178e-05, c4 = -2.75573143513906633035e-07,
                   c5 = 2.08757232129817482790e-09, c6 = -1.13596475577881948265e-11;
  return 1.0 +
         square *
             (-0.5 +
              square *
                  (c1 +
                   square * (c2 + square * (c3 + square * (c4 + square * (c5 + square * c6))))));
}

}  // namespace rigid_body_sim
