#pragma once

#include <cstddef>

#include "dynamics/taylor/lanes.hpp"
#include "dynamics/taylor/taylor_equations.hpp"

/// Sums of products of the coefficients so far, from which the recursion of the Taylor segment
/// makes the next. Included by taylor_recursion.cpp alone, which compiles them for several
/// processors.
namespace rigid_body_sim {

/// The coefficients of one degree of ω and q, with their components in the places where the
/// products need them.
template <class T>
struct Arranged {
  Lanes<T> w_yzx, w_zxy;
  Lanes<T> w_x, w_y, w_z;  // ω₁, ω₂, ω₃ in all lanes
  Lanes<T> q_x, q_y, q_z;  // what these are multiplied with in ½ q (0, ω)
  Lanes<T> q;
  Lanes<T> q_cross, q_turn;  // (x + y, y + z, z + x) and (x + w, y + w, z + w)
};

/// Those so far.
template <class T>
class ArrangedSeries {
 public:
  RIGID_BODY_SIM_INLINE ArrangedSeries() {
    const T half = T(1) / T(2);
    set<T>(half, half, -half, -half, half_x_);
    set<T>(-half, half, half, -half, half_y_);
    set<T>(half, -half, half, -half, half_z_);
  }

  RIGID_BODY_SIM_INLINE const Arranged<T>& operator[](std::size_t k) const { return of_[k]; }

  template <bool kTurned>
  RIGID_BODY_SIM_INLINE void put(std::size_t k, const Lanes<T>& w, const Lanes<T>& q) {
    Arranged<T>& a = of_[k];
    permute<1, 2, 0, 3, T>(w, a.w_yzx);
    permute<2, 0, 1, 3, T>(w, a.w_zxy);
    permute<0, 0, 0, 0, T>(w, a.w_x);
    permute<1, 1, 1, 1, T>(w, a.w_y);
    permute<2, 2, 2, 2, T>(w, a.w_z);
    Lanes<T> wzyx, zwxy, yxwz;
    permute<3, 2, 1, 0, T>(q, wzyx);
    permute<2, 3, 0, 1, T>(q, zwxy);
    permute<1, 0, 3, 2, T>(q, yxwz);
    a.q_x = wzyx * half_x_;
    a.q_y = zwxy * half_y_;
    a.q_z = yxwz * half_z_;
    if (!kTurned) return;
    Lanes<T> yzx, www;
    permute<1, 2, 0, 3, T>(q, yzx);
    permute<3, 3, 3, 3, T>(q, www);
    a.q = q;
    a.q_cross = q + yzx;
    a.q_turn = q + www;
  }

 private:
  Arranged<T> of_[kHighestTaylorDegree];
  Lanes<T> half_x_, half_y_, half_z_;  // ½ and signs
};

/// The sums over coefficients of the degrees 1 to k − 1 that add up to k. What the coefficients of
/// degree k themselves bring in, which come last, is kept apart: nothing but that waits for them.
template <class T>
struct Products {
  Lanes<T> ww;                       ///< (ω₂ ω₃, ω₃ ω₁, ω₁ ω₂)
  Lanes<T> qw_x, qw_y, qw_z;         ///< ½ q (0, ω), the parts of ω₁, ω₂ and ω₃
  Lanes<T> squares, crosses, turns;  ///< of the components of q

  RIGID_BODY_SIM_INLINE Products() {
    set<T>(0, 0, 0, 0, ww);
    qw_x = qw_y = qw_z = squares = crosses = turns = ww;
  }

  /// Of squares, crosses and turns also what the newest coefficients bring in.
  RIGID_BODY_SIM_INLINE void addNewest(const ArrangedSeries<T>& a, std::size_t k) {
    Lanes<T> yzx_0, yzx_k, w_0, w_k;
    permute<1, 2, 0, 3, T>(a[0].q, yzx_0);
    permute<1, 2, 0, 3, T>(a[k].q, yzx_k);
    permute<3, 3, 3, 3, T>(a[0].q, w_0);
    permute<3, 3, 3, 3, T>(a[k].q, w_k);
    const Lanes<T> square = a[0].q * a[k].q;
    squares += square;
    crosses += a[0].q * yzx_k;
    turns += a[0].q * w_k;
    if (k == 0) return;
    squares += square;
    crosses += a[k].q * yzx_0;
    turns += a[k].q * w_0;
  }
};

/// The products of an even degree and of the next, found in one pass through the coefficients: what
/// is loaded serves both. Those of q with itself are sums of squares, in which each term comes
/// twice: 2 x y = (x + y)² − x² − y².
template <class T, bool kTurned>
class TwoProducts {
 public:
  /// Those of the degree k, which is even, and of k + 1 what the degrees below k bring in.
  RIGID_BODY_SIM_INLINE void begin(const ArrangedSeries<T>& a, std::size_t k, Products<T>& now) {
    if (k == 0) {
      now = next_ = Products<T>();
      return;
    }
    const Arranged<T>*low = &a[1], *high = &a[k - 1];
    start(*low, *high, now);
    if (k == 2) {
      next_ = Products<T>();
      if (!kTurned) return;
      startSquare(*low, now);
      unite(now);
      return;
    }
    ++low;
    start(*low, *high, next_);
    --high;
    add(*low, *high, now);
    for (const Arranged<T>* last = &a[k - 1]; low != last;) {
      ++low;
      add(*low, *high, next_);
      --high;
      add(*low, *high, now);
    }
    if (kTurned) beginHalves(a, k, now);
  }

  /// Those of k + 1, with what the degree k brings in.
  RIGID_BODY_SIM_INLINE void end(const ArrangedSeries<T>& a, std::size_t k, Products<T>& now) {
    now = next_;
    if (k == 0) return;
    add(a[1], a[k], now);
    add(a[k], a[1], now);
    if (!kTurned) return;
    addHalf(a[1], a[k], now);
    unite(now);
  }

 private:
  RIGID_BODY_SIM_INLINE static void start(const Arranged<T>& a, const Arranged<T>& b,
                                          Products<T>& p) {
    p.ww = a.w_yzx * b.w_zxy;
    p.qw_x = a.q_x * b.w_x;
    p.qw_y = a.q_y * b.w_y;
    p.qw_z = a.q_z * b.w_z;
  }
  RIGID_BODY_SIM_INLINE static void add(const Arranged<T>& a, const Arranged<T>& b,
                                        Products<T>& p) {
    p.ww += a.w_yzx * b.w_zxy;
    p.qw_x += a.q_x * b.w_x;
    p.qw_y += a.q_y * b.w_y;
    p.qw_z += a.q_z * b.w_z;
  }

  /// k > 2.
  RIGID_BODY_SIM_INLINE void beginHalves(const ArrangedSeries<T>& a, std::size_t k,
                                         Products<T>& now) {
    const Arranged<T>*low = &a[k / 2], *high = low + 1;
    startSquare(*low, now);
    startHalf(*low, *high, next_);
    for (const Arranged<T>* first = &a[1];;) {
      --low;
      addHalf(*low, *high, now);
      if (low == first) break;
      ++high;
      addHalf(*low, *high, next_);
    }
    unite(now);
  }

  // half the sums of x², (x + y)² and (x + w)²
  RIGID_BODY_SIM_INLINE static void startSquare(const Arranged<T>& a, Products<T>& p) {
    const T half = T(1) / T(2);
    p.squares = a.q * half * a.q;
    p.crosses = a.q_cross * half * a.q_cross;
    p.turns = a.q_turn * half * a.q_turn;
  }
  RIGID_BODY_SIM_INLINE static void startHalf(const Arranged<T>& a, const Arranged<T>& b,
                                              Products<T>& p) {
    p.squares = a.q * b.q;
    p.crosses = a.q_cross * b.q_cross;
    p.turns = a.q_turn * b.q_turn;
  }
  RIGID_BODY_SIM_INLINE static void addHalf(const Arranged<T>& a, const Arranged<T>& b,
                                            Products<T>& p) {
    p.squares += a.q * b.q;
    p.crosses += a.q_cross * b.q_cross;
    p.turns += a.q_turn * b.q_turn;
  }

  /// From these halves the sums themselves.
  RIGID_BODY_SIM_INLINE static void unite(Products<T>& p) {
    Lanes<T> yzx, www;
    permute<1, 2, 0, 3, T>(p.squares, yzx);
    permute<3, 3, 3, 3, T>(p.squares, www);
    p.crosses = (p.crosses - p.squares) - yzx;
    p.turns = (p.turns - p.squares) - www;
    p.squares += p.squares;
  }

  Products<T> next_;
};

/// A vector that a matrix takes lanes to: Σ columnᵢ laneᵢ.
template <class T>
RIGID_BODY_SIM_INLINE void multiply(const Lanes<T> (&column)[4], const Lanes<T>& by, Lanes<T>& to) {
  Lanes<T> x, y, z, w;
  permute<0, 0, 0, 0, T>(by, x);
  permute<1, 1, 1, 1, T>(by, y);
  permute<2, 2, 2, 2, T>(by, z);
  permute<3, 3, 3, 3, T>(by, w);
  to = (column[0] * x + column[1] * y) + (column[2] * z + column[3] * w);
}

/// The coefficient k of ½ q (0, ω), from the products without those of degree k.
template <class T>
RIGID_BODY_SIM_INLINE void turnOf(const ArrangedSeries<T>& a, const Products<T>& older,
                                  std::size_t k, Lanes<T>& to) {
  to = (a[0].q_x * a[k].w_x + a[0].q_y * a[k].w_y) + a[0].q_z * a[k].w_z;
  if (k == 0) return;
  to += ((older.qw_x + older.qw_y) + older.qw_z) +
        ((a[k].q_x * a[0].w_x + a[k].q_y * a[0].w_y) + a[k].q_z * a[0].w_z);
}

/// Where nothing turns with the attitude.
struct NoTurning {
  template <class Equations, class Q>
  RIGID_BODY_SIM_INLINE NoTurning(const Equations&, const Q&) {}
};

/// What turns with the attitude in ω'.
template <class T>
class Turning {
 public:
  RIGID_BODY_SIM_INLINE Turning(const TaylorEquations<T>& equations, const Lanes<T>& q_0) {
    for (int j = 0; j < 9; ++j) load<T>(equations.turning[j], of_[j]);
    const Lanes<T>& q = q_0;
    newest_[0] = (of_[0] * (2 * q[0]) + of_[3] * q[1]) + (of_[5] * q[2] + of_[6] * q[3]);
    newest_[1] = (of_[1] * (2 * q[1]) + of_[3] * q[0]) + (of_[4] * q[2] + of_[7] * q[3]);
    newest_[2] = (of_[2] * (2 * q[2]) + of_[4] * q[1]) + (of_[5] * q[0] + of_[8] * q[3]);
    newest_[3] = (of_[6] * q[0] + of_[7] * q[1]) + of_[8] * q[2];
  }

  RIGID_BODY_SIM_INLINE void older(const Products<T>& p, Lanes<T>& to) const {
    to = ((of_[0] * p.squares[0] + of_[1] * p.squares[1]) +
          (of_[2] * p.squares[2] + of_[3] * p.crosses[0])) +
         ((of_[4] * p.crosses[1] + of_[5] * p.crosses[2]) +
          (of_[6] * p.turns[0] + of_[7] * p.turns[1])) +
         of_[8] * p.turns[2];
  }

  /// Of q_k with q_0.
  RIGID_BODY_SIM_INLINE void newest(const Lanes<T>& q_k, std::size_t k, Lanes<T>& to) const {
    multiply<T>(newest_, q_k, to);
    if (k == 0) to = to * (T(1) / T(2));
  }

 private:
  Lanes<T> of_[9];
  Lanes<T> newest_[4];
};

}  // namespace rigid_body_sim
