#pragma once

#include "math/always_inline.hpp"

/// Packs: the same number of several bodies, as one value. Every operation is that on each of the
/// numbers by itself, so that width changes no bit.
namespace rigid_body_sim {

template <int kLanes>
struct VectorOf;
template <>
struct VectorOf<2> {
  using Type __attribute__((vector_size(16), aligned(8), may_alias)) = double;
};
template <>
struct VectorOf<4> {
  using Type __attribute__((vector_size(32), aligned(8), may_alias)) = double;
};
template <>
struct VectorOf<8> {
  using Type __attribute__((vector_size(64), aligned(8), may_alias)) = double;
};

/// One register.
template <int kLanes>
struct Pack {
  typename VectorOf<kLanes>::Type v;

  Pack() = default;
  RIGID_BODY_SIM_INLINE Pack(double x) : v(x - typename VectorOf<kLanes>::Type{}) {}

  friend RIGID_BODY_SIM_INLINE Pack operator+(const Pack& a, const Pack& b) {
    Pack c;
    c.v = a.v + b.v;
    return c;
  }
  friend RIGID_BODY_SIM_INLINE Pack operator-(const Pack& a, const Pack& b) {
    Pack c;
    c.v = a.v - b.v;
    return c;
  }
  friend RIGID_BODY_SIM_INLINE Pack operator*(const Pack& a, const Pack& b) {
    Pack c;
    c.v = a.v * b.v;
    return c;
  }
  friend RIGID_BODY_SIM_INLINE Pack operator/(const Pack& a, const Pack& b) {
    Pack c;
    c.v = a.v / b.v;
    return c;
  }
};

/// Two registers: while one waits for a result, the other is computed.
template <int kLanes>
struct Twin {
  Pack<kLanes> a, b;

  Twin() = default;
  RIGID_BODY_SIM_INLINE Twin(double x) : a(x), b(x) {}
  RIGID_BODY_SIM_INLINE Twin(const Pack<kLanes>& first, const Pack<kLanes>& second)
      : a(first), b(second) {}

  friend RIGID_BODY_SIM_INLINE Twin operator+(const Twin& s, const Twin& t) {
    return {s.a + t.a, s.b + t.b};
  }
  friend RIGID_BODY_SIM_INLINE Twin operator-(const Twin& s, const Twin& t) {
    return {s.a - t.a, s.b - t.b};
  }
  friend RIGID_BODY_SIM_INLINE Twin operator*(const Twin& s, const Twin& t) {
    return {s.a * t.a, s.b * t.b};
  }
  friend RIGID_BODY_SIM_INLINE Twin operator/(const Twin& s, const Twin& t) {
    return {s.a / t.a, s.b / t.b};
  }
};

/// Numbers side by side in memory, and back. Not by memcpy, which the compiler may do in pieces
/// that are as narrow as the narrowest registers.
RIGID_BODY_SIM_INLINE void load(const double* from, double& to) { to = *from; }
RIGID_BODY_SIM_INLINE void store(double from, double* to) { *to = from; }

template <int kLanes>
RIGID_BODY_SIM_INLINE void load(const double* from, Pack<kLanes>& to) {
  to.v = *reinterpret_cast<const typename VectorOf<kLanes>::Type*>(from);
}

template <int kLanes>
RIGID_BODY_SIM_INLINE void store(const Pack<kLanes>& from, double* to) {
  *reinterpret_cast<typename VectorOf<kLanes>::Type*>(to) = from.v;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE void load(const double* from, Twin<kLanes>& to) {
  load(from, to.a);
  load(from + kLanes, to.b);
}

template <int kLanes>
RIGID_BODY_SIM_INLINE void store(const Twin<kLanes>& from, double* to) {
  store(from.a, to);
  store(from.b, to + kLanes);
}

/// max(0, x), 0 for what is not a number.
RIGID_BODY_SIM_INLINE double positivePart(double x) { return x > 0 ? x : 0; }

template <int kLanes>
RIGID_BODY_SIM_INLINE Pack<kLanes> positivePart(const Pack<kLanes>& x) {
  using Bits __attribute__((vector_size(8 * kLanes))) = long long;
  Pack<kLanes> positive;
  positive.v = (typename VectorOf<kLanes>::Type)((Bits)x.v & (Bits)(x.v > 0.0));
  return positive;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE Twin<kLanes> positivePart(const Twin<kLanes>& x) {
  return {positivePart(x.a), positivePart(x.b)};
}

/// 1 where x > 0, else 0.
RIGID_BODY_SIM_INLINE double oneWherePositive(double x) { return x > 0 ? 1 : 0; }

template <int kLanes>
RIGID_BODY_SIM_INLINE Pack<kLanes> oneWherePositive(const Pack<kLanes>& x) {
  using Bits __attribute__((vector_size(8 * kLanes))) = long long;
  Pack<kLanes> one(1.0);
  one.v = (typename VectorOf<kLanes>::Type)((Bits)one.v & (Bits)(x.v > 0.0));
  return one;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE Twin<kLanes> oneWherePositive(const Twin<kLanes>& x) {
  return {oneWherePositive(x.a), oneWherePositive(x.b)};
}

RIGID_BODY_SIM_INLINE bool anyNonZero(double x) { return x != 0; }

template <int kLanes>
RIGID_BODY_SIM_INLINE bool anyNonZero(const Pack<kLanes>& x) {
  bool any = false;
  for (int i = 0; i < kLanes; ++i) any |= x.v[i] != 0;
  return any;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE bool anyNonZero(const Twin<kLanes>& x) {
  return anyNonZero(x.a) || anyNonZero(x.b);
}

RIGID_BODY_SIM_INLINE double absolute(double x) { return __builtin_fabs(x); }

template <int kLanes>
RIGID_BODY_SIM_INLINE Pack<kLanes> absolute(const Pack<kLanes>& x) {
  using Bits __attribute__((vector_size(8 * kLanes))) = long long;
  constexpr long long kAllButSign = 0x7fffffffffffffff;
  Pack<kLanes> size;
  size.v = (typename VectorOf<kLanes>::Type)((Bits)x.v & kAllButSign);
  return size;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE Twin<kLanes> absolute(const Twin<kLanes>& x) {
  return {absolute(x.a), absolute(x.b)};
}

RIGID_BODY_SIM_INLINE double squareRoot(double x) { return __builtin_sqrt(x); }

template <int kLanes>
RIGID_BODY_SIM_INLINE Pack<kLanes> squareRoot(const Pack<kLanes>& x) {
  Pack<kLanes> root;
  for (int i = 0; i < kLanes; ++i) root.v[i] = __builtin_sqrt(x.v[i]);
  return root;
}

template <int kLanes>
RIGID_BODY_SIM_INLINE Twin<kLanes> squareRoot(const Twin<kLanes>& x) {
  return {squareRoot(x.a), squareRoot(x.b)};
}

}  // namespace rigid_body_sim
