#pragma once

#include <cstddef>

#include <rigid_body_sim/dynamics/state.hpp>

#include "dynamics/packs/transpose.hpp"

/// States as columns: a number of several bodies side by side.
namespace rigid_body_sim {

/// In the order of BodyState.
enum StateColumn : int {
  kPositionColumn = 0,     ///< x_W, three columns
  kPositionLowColumn = 3,  ///< x_low_W, three
  kAttitudeColumn = 6,     ///< q_WP: x, y, z, w
  kMomentumColumn = 10,    ///< p_W, three
  kWorldSpinColumn = 13,   ///< L_W, three
  kSpinColumn = 16,        ///< L_P, three
  kStateColumns = 19
};
static_assert(sizeof(BodyState) == kStateColumns * sizeof(double),
              "a state must be nothing but its numbers");

inline const double* stateNumbers(const BodyState& state) {
  return reinterpret_cast<const double*>(&state);
}
inline double* stateNumbers(BodyState& state) { return reinterpret_cast<double*>(&state); }

/// Writes one state.
template <std::size_t lanes>
void copyState(const double (*columns)[lanes], std::size_t lane, BodyState& state) {
  double* const to = stateNumbers(state);
  // in two loops, which are short enough for the compiler to write them out
  for (int c = 0; c < kWorldSpinColumn; ++c) to[c] = columns[c][lane];
  for (int c = kWorldSpinColumn; c < kStateColumns; ++c) to[c] = columns[c][lane];
}

/// Writes the states of all lanes.
template <std::size_t lanes>
RIGID_BODY_SIM_INLINE void copyStates(const double (*columns)[lanes], BodyState* const* states) {
  for (std::size_t lane = 0; lane < lanes; lane += 4)
    for (const int c : {0, 4, 8, 12, kStateColumns - 4}) {  // the last overlap those before by one
      const auto from = [&](int i) { return columns[c + i] + lane; };
      const auto to = [&](std::size_t k) { return stateNumbers(*states[lane + k]) + c; };
      transposeFour({from(0), from(1), from(2), from(3)}, {to(0), to(1), to(2), to(3)});
    }
}

}  // namespace rigid_body_sim
