#pragma once

#include <type_traits>

#include <rigid_body_sim/math/types.hpp>

#include "math/always_inline.hpp"

namespace rigid_body_sim {

/// Four numbers as one: lanes of the processor, or of Eigen for long double.
template <class T>
struct LanesOf {
  using Type = Eigen::Array<T, 4, 1>;
};
template <>
struct LanesOf<double> {
#if defined(__clang__)
  // clang forgets an alignment of its own where the type goes through a template, though not in the
  // layout of a class, and then stores to a member as if it were aligned to its size
  using Type __attribute__((vector_size(32))) = double;
#else
  using Type __attribute__((vector_size(32), aligned(8))) = double;
#endif
};
template <class T>
using Lanes = typename LanesOf<T>::Type;

template <class T>
RIGID_BODY_SIM_INLINE void set(T x, T y, T z, T w, Lanes<T>& lanes) {
  lanes = Lanes<T>{x, y, z, w};
}

template <class T>
RIGID_BODY_SIM_INLINE void load(const T (&from)[4], Lanes<T>& lanes) {
  set<T>(from[0], from[1], from[2], from[3], lanes);
}

template <class T>
RIGID_BODY_SIM_INLINE void store(const Lanes<T>& lanes, T (&to)[4]) {
  for (int i = 0; i < 4; ++i) to[i] = lanes[i];
}

/// The components in another order.
template <int a, int b, int c, int d, class T>
RIGID_BODY_SIM_INLINE void permute(const Lanes<T>& from, Lanes<T>& to) {
  if constexpr (std::is_same_v<T, double>) {
#if defined(__clang__)
    to = __builtin_shufflevector(from, from, a, b, c, d);
#else
    typedef long long Order __attribute__((vector_size(32)));
    to = __builtin_shuffle(from, Order{a, b, c, d});
#endif
  } else {
    set<T>(from[a], from[b], from[c], from[d], to);
  }
}

}  // namespace rigid_body_sim
