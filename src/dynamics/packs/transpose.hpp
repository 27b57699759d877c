#pragma once

#include "math/always_inline.hpp"

/// From the numbers of each body to a number of each body, and back. Included by what is compiled
/// for several instruction sets.
namespace rigid_body_sim {

using FourNumbers __attribute__((vector_size(32), aligned(8), may_alias)) = double;

/// Four numbers of two times four.
template <int a, int b, int c, int d>
RIGID_BODY_SIM_INLINE void choose(const FourNumbers& low, const FourNumbers& high,
                                  FourNumbers& to) {
#if defined(__clang__)
  to = __builtin_shufflevector(low, high, a, b, c, d);
#else
  using Order __attribute__((vector_size(32))) = long long;
  to = __builtin_shuffle(low, high, Order{a, b, c, d});
#endif
}

/// Four rows of four numbers to their columns.
RIGID_BODY_SIM_INLINE void transposeFour(const double* const (&rows)[4],
                                         double* const (&columns)[4]) {
  FourNumbers row[4], even_01, odd_01, even_23, odd_23, column;
  for (int i = 0; i < 4; ++i) row[i] = *reinterpret_cast<const FourNumbers*>(rows[i]);
  choose<0, 4, 2, 6>(row[0], row[1], even_01);
  choose<1, 5, 3, 7>(row[0], row[1], odd_01);
  choose<0, 4, 2, 6>(row[2], row[3], even_23);
  choose<1, 5, 3, 7>(row[2], row[3], odd_23);
  choose<0, 1, 4, 5>(even_01, even_23, column);
  *reinterpret_cast<FourNumbers*>(columns[0]) = column;
  choose<0, 1, 4, 5>(odd_01, odd_23, column);
  *reinterpret_cast<FourNumbers*>(columns[1]) = column;
  choose<2, 3, 6, 7>(even_01, even_23, column);
  *reinterpret_cast<FourNumbers*>(columns[2]) = column;
  choose<2, 3, 6, 7>(odd_01, odd_23, column);
  *reinterpret_cast<FourNumbers*>(columns[3]) = column;
}

}  // namespace rigid_body_sim
