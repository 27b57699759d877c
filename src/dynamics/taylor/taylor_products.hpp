#pragma once

#include <cstddef>

#include "dynamics/taylor/lanes.hpp"
#include "dynamics/taylor/taylor_equations.hpp"

/// Sums of products of the coefficients so far, from which the recursion of the Taylor segment
/// makes the next. Included by taylor_recursion.cpp alone, which compiles them for several
/// processors.
namespace rigid_body_sim {

/// The coefficients of one degree of ω and q, with their components in the places where the
/// products need them: left[i] × right[i] of two degrees, and squares of the others.
template <class T>
struct Arranged {
  Lanes<T> left[4];  // ω (y, z, x), and what ω₁, ω₂ and ω₃ are multiplied with in ½ q (0, ω)
  Lanes<T> right[4];  // ω (z, x, y), and ω₁, ω₂, ω₃ in all lanes
  Lanes<T> mixed[2];  // (x + y, y + z, z + x) and (x + w, y + w, z + w) of q
  Lanes<T> q;
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
    permute<1, 2, 0, 3, T>(w, a.left[0]);
    permute<2, 0, 1, 3, T>(w, a.right[0]);
    permute<0, 0, 0, 0, T>(w, a.right[1]);
    permute<1, 1, 1, 1, T>(w, a.right[2]);
    permute<2, 2, 2, 2, T>(w, a.right[3]);
    Lanes<T> wzyx, zwxy, yxwz;
    permute<3, 2, 1, 0, T>(q, wzyx);
    permute<2, 3, 0, 1, T>(q, zwxy);
    permute<1, 0, 3, 2, T>(q, yxwz);
    a.left[1] = wzyx * half_x_;
    a.left[2] = zwxy * half_y_;
    a.left[3] = yxwz * half_z_;
    if (!kTurned) return;
    Lanes<T> yzx, www;
    permute<1, 2, 0, 3, T>(q, yzx);
    permute<3, 3, 3, 3, T>(q, www);
    a.mixed[0] = q + yzx;
    a.mixed[1] = q + www;
    a.q = q;
  }

 private:
  Arranged<T> of_[kHighestTaylorDegree];
  Lanes<T> half_x_, half_y_, half_z_;  // ½ and signs
};

/// The sums over coefficients of the degrees 1 to k − 1 that add up to k. What the coefficients of
/// degree k themselves bring in, which come last, is kept apart: nothing but that waits for them.
// NOLINTBEGIN(bugprone-reserved-identifier): __i0, by which the compiler goes through of_w
template <class T>
struct Products {
  Lanes<T> of_w[4];  ///< (ω₂ ω₃, ω₃ ω₁, ω₁ ω₂); of ½ q (0, ω) what ω₁, ω₂, ω₃ bring
  Lanes<T> squares, crosses, turns;  ///< of the components of q

  RIGID_BODY_SIM_INLINE Products() {
    set<T>(0, 0, 0, 0, squares);
    crosses = turns = of_w[0] = of_w[1] = of_w[2] = of_w[3] = squares;
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
// NOLINTEND(bugprone-reserved-identifier)

/// The products of an even degree and of the next, found in one pass through the coefficients: what
/// is loaded serves both. Those of q with itself are sums of squares, in which each term comes
/// twice: 2 x y = (x + y)² − x² − y².
template <class T, bool kTurned>
class TwoProducts {
 public:
  RIGID_BODY_SIM_INLINE TwoProducts() {  // or GCC warns, which does not see the order of the calls
    Lanes<T>& zero = next_.squares;
    set<T>(0, 0, 0, 0, zero);
    for (Lanes<T>& sum : next_.of_w) sum = zero;
    for (Lanes<T>& sum : next_.mixed) sum = zero;
  }

  /// Those of the degree k, which is even, and of k + 1 what the degrees below k bring in.
  RIGID_BODY_SIM_INLINE void begin(const ArrangedSeries<T>& a, std::size_t k, Products<T>& now) {
    if (k < 4) return beginFirst(a, k, now);
    Sums of_k;
    const Arranged<T>*low = &a[1], *high = &a[k - 1];
    start(*low, *high, of_k);
    ++low;
    start(*low, *high, next_);
    --high;
    add(*low, *high, of_k);
    for (const Arranged<T>* last = &a[k - 1]; low != last;) {
      ++low;
      add(*low, *high, next_);
      --high;
      add(*low, *high, of_k);
    }
    if (kTurned) beginHalves(a, k, of_k);
    getFrom(of_k, now);
  }

  /// Those of k + 1, with what the degree k brings in.
  RIGID_BODY_SIM_INLINE void end(const ArrangedSeries<T>& a, std::size_t k, Products<T>& now) {
    if (k == 0) {
      now = Products<T>();
      return;
    }
    if (k == 2) {
      start(a[1], a[2], next_);
      startHalf(a[1], a[2], next_);
    } else {
      add(a[1], a[k], next_);
      addHalf(a[1], a[k], next_);
    }
    add(a[k], a[1], next_);
    getFrom(next_, now);
  }

 private:
  struct Sums {
    Lanes<T> of_w[4];
    Lanes<T> mixed[2];  // half the sums of (x + y)² …, (x + w)² …
    Lanes<T> squares;   // and of x² …
  };

  RIGID_BODY_SIM_INLINE void beginFirst(const ArrangedSeries<T>& a, std::size_t k,
                                        Products<T>& now) {
    now = Products<T>();
    if (k == 0) return;
    Sums of_k;
    start(a[1], a[1], of_k);
    startSquare(a[1], of_k);
    getFrom(of_k, now);
  }

  /// From the middle outwards.
  RIGID_BODY_SIM_INLINE void beginHalves(const ArrangedSeries<T>& a, std::size_t k, Sums& of_k) {
    const Arranged<T>*low = &a[k / 2], *high = low + 1;
    startSquare(*low, of_k);
    startHalf(*low, *high, next_);
    for (const Arranged<T>* first = &a[1];;) {
      --low;
      addHalf(*low, *high, of_k);
      if (low == first) return;
      ++high;
      addHalf(*low, *high, next_);
    }
  }

  RIGID_BODY_SIM_INLINE static void start(const Arranged<T>& a, const Arranged<T>& b, Sums& sums) {
    for (int i = 0; i < 4; ++i) sums.of_w[i] = a.left[i] * b.right[i];
  }
  RIGID_BODY_SIM_INLINE static void add(const Arranged<T>& a, const Arranged<T>& b, Sums& sums) {
    for (int i = 0; i < 4; ++i) sums.of_w[i] += a.left[i] * b.right[i];
  }

  RIGID_BODY_SIM_INLINE static void startSquare(const Arranged<T>& a, Sums& sums) {
    if (!kTurned) return;
    const T half = T(1) / T(2);
    for (int i = 0; i < 2; ++i) sums.mixed[i] = a.mixed[i] * half * a.mixed[i];
    sums.squares = a.q * half * a.q;
  }
  RIGID_BODY_SIM_INLINE static void startHalf(const Arranged<T>& a, const Arranged<T>& b,
                                              Sums& sums) {
    if (!kTurned) return;
    for (int i = 0; i < 2; ++i) sums.mixed[i] = a.mixed[i] * b.mixed[i];
    sums.squares = a.q * b.q;
  }
  RIGID_BODY_SIM_INLINE static void addHalf(const Arranged<T>& a, const Arranged<T>& b,
                                            Sums& sums) {
    if (!kTurned) return;
    for (int i = 0; i < 2; ++i) sums.mixed[i] += a.mixed[i] * b.mixed[i];
    sums.squares += a.q * b.q;
  }

  RIGID_BODY_SIM_INLINE static void getFrom(const Sums& sums, Products<T>& to) {
    for (int i = 0; i < 4; ++i) to.of_w[i] = sums.of_w[i];
    if (!kTurned) return;
    Lanes<T> yzx, www;
    permute<1, 2, 0, 3, T>(sums.squares, yzx);
    permute<3, 3, 3, 3, T>(sums.squares, www);
    to.crosses = (sums.mixed[0] - sums.squares) - yzx;
    to.turns = (sums.mixed[1] - sums.squares) - www;
    to.squares = sums.squares + sums.squares;
  }

  Sums next_;
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
RIGID_BODY_SIM_INLINE void turnOf(const ArrangedSeries<T>& series, const Products<T>& older,
                                  std::size_t k, Lanes<T>& to) {
  const Arranged<T>& a = series[0];
  const Arranged<T>& b = series[k];
  to = (a.left[1] * b.right[1] + a.left[2] * b.right[2]) + a.left[3] * b.right[3];
  if (k == 0) return;
  to += ((older.of_w[1] + older.of_w[2]) + older.of_w[3]) +
        ((b.left[1] * a.right[1] + b.left[2] * a.right[2]) + b.left[3] * a.right[3]);
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
