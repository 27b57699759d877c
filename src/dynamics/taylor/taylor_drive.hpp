#pragma once

#include <cstddef>

#include "dynamics/taylor/taylor_equations.hpp"

namespace rigid_body_sim {

/// What changes with time in the equations of a TaylorSegment, as series in the segment's unit of
/// time, principal axes. Of a body with the angular momentum H of wheels and rotors:
///   ω' = … + I⁻¹ (τ − H′) + I⁻¹ (H × ω),   p' = … + R f,   L_W' = … + R τ
template <class T>
struct TaylorDrive {
  using Coefficients = typename TaylorSeries<T>::Coefficients;

  Coefficients force;         ///< [N] f
  Coefficients torque;        ///< [N m] τ
  Coefficients momentum;      ///< H, by time in the unit of the series
  Coefficients acceleration;  ///< I⁻¹ (τ − H′), likewise
  T inv_I[4];                 ///< [1/(kg m²)]
  T inv_mass;                 ///< of the body, by time in the unit of the series, squared
  /// How many of the coefficients may be other than zero.
  std::size_t force_terms, torque_terms, momentum_terms;

  Coefficients impulse;  ///< what comes out: the integral of R f, from degree 1 on
  Coefficients twist;    ///< of R τ
};

}  // namespace rigid_body_sim
