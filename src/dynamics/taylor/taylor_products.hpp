#pragma once

#include <cstddef>

#include "dynamics/taylor/lanes.hpp"
#include "dynamics/taylor/taylor_equations.hpp"

/// Sums of products of the coefficients so far, from which the recursion of the Taylor segment
/// makes the next. Included by taylor_recursion.cpp alone, which compiles them for several
/// processors.
namespace rigid_body_sim {

/// The coefficients of ω and q so far, also with their components in the places where the products
/// need them.
template <class T>
struct Arranged {
  static constexpr std::size_t kSize = kHighestTaylorDegree;
  Lanes<T> w_yzx[kSize], w_zxy[kSize];
  Lanes<T> q[kSize], q_x[kSize], q_y[kSize], q_z[kSize], q_yzx[kSize];

  RIGID_BODY_SIM_INLINE void add(std::size_t k, const Lanes<T>& w_k, const Lanes<T>& q_k) {
    permute<1, 2, 0, 3, T>(w_k, w_yzx[k]);
    permute<2, 0, 1, 3, T>(w_k, w_zxy[k]);
    q[k] = q_k;
    permute<3, 2, 1, 0, T>(q_k, q_x[k]);
    permute<2, 3, 0, 1, T>(q_k, q_y[k]);
    permute<1, 0, 3, 2, T>(q_k, q_z[k]);
    permute<1, 2, 0, 3, T>(q_k, q_yzx[k]);
  }
};

/// The sums over coefficients of the degrees 1 to k − 1 that add up to k. What the coefficients of
/// degree k themselves bring in, which come last, is kept apart: nothing but that waits for them.
template <class T>
struct Products {
  Lanes<T> ww;                ///< (ω₂ ω₃, ω₃ ω₁, ω₁ ω₂)
  Lanes<T> qw_x, qw_y, qw_z;  ///< of q with ω₁, ω₂, ω₃, but for signs
  Lanes<T> squares, crosses, turns;

  template <bool kTurned>
  RIGID_BODY_SIM_INLINE void sum(const Arranged<T>& a, const TaylorSeries<T>& series,
                                 std::size_t k) {
    set<T>(0, 0, 0, 0, ww);
    qw_x = qw_y = qw_z = squares = crosses = turns = ww;
    for (std::size_t i = 1, j = k - 1; i < k; ++i, --j) {
      ww += a.w_yzx[i] * a.w_zxy[j];
      qw_x += a.q_x[i] * series.w[j][0];
      qw_y += a.q_y[i] * series.w[j][1];
      qw_z += a.q_z[i] * series.w[j][2];
      if (!kTurned) continue;
      crosses += a.q[i] * a.q_yzx[j];
      turns += a.q[i] * series.q[j][3];
    }
    if (!kTurned) return;
    for (std::size_t i = 1; 2 * i < k; ++i) squares += a.q[i] * a.q[k - i];
    squares = squares + squares;
    if (k > 0 && k % 2 == 0) squares += a.q[k / 2] * a.q[k / 2];
  }

  /// Of the squares, crosses and turns also what the newest coefficients bring in.
  RIGID_BODY_SIM_INLINE void addNewest(const Arranged<T>& a, std::size_t k) {
    Lanes<T> w_0, w_k;
    permute<3, 3, 3, 3, T>(a.q[0], w_0);
    permute<3, 3, 3, 3, T>(a.q[k], w_k);
    const Lanes<T> square = a.q[0] * a.q[k];
    squares += square;
    crosses += a.q[0] * a.q_yzx[k];
    turns += a.q[0] * w_k;
    if (k == 0) return;
    squares += square;
    crosses += a.q[k] * a.q_yzx[0];
    turns += a.q[k] * w_0;
  }
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

/// ½ q (0, ω) of the newest coefficients with those of degree 0, of which it is made.
template <class T>
class NewestTurn {
 public:
  RIGID_BODY_SIM_INLINE NewestTurn(const Lanes<T>& w_0, const Arranged<T>& a) {
    const T half = T(1) / T(2);
    set<T>(half, half, -half, -half, sign_x_);
    set<T>(-half, half, half, -half, sign_y_);
    set<T>(half, -half, half, -half, sign_z_);
    of_w_[0] = a.q_x[0] * sign_x_;
    of_w_[1] = a.q_y[0] * sign_y_;
    of_w_[2] = a.q_z[0] * sign_z_;
    set<T>(0, 0, 0, 0, of_w_[3]);
    of_q_x_ = sign_x_ * w_0[0];
    of_q_y_ = sign_y_ * w_0[1];
    of_q_z_ = sign_z_ * w_0[2];
  }

  /// The whole coefficient k of q'.
  RIGID_BODY_SIM_INLINE void q_dot(const Arranged<T>& a, const Products<T>& older,
                                   const Lanes<T>& w_k, std::size_t k, Lanes<T>& to) const {
    multiply<T>(of_w_, w_k, to);
    if (k == 0) return;
    to += (older.qw_x * sign_x_ + older.qw_y * sign_y_ + older.qw_z * sign_z_) +
          (a.q_x[k] * of_q_x_ + a.q_y[k] * of_q_y_ + a.q_z[k] * of_q_z_);
  }

 private:
  Lanes<T> sign_x_, sign_y_, sign_z_;  // of the components of q × ω₁ …, times ½
  Lanes<T> of_w_[4];
  Lanes<T> of_q_x_, of_q_y_, of_q_z_;
};

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
