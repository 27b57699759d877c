#include "taylor_recursion.hpp"

#include <array>
#include <type_traits>

#include "lanes.hpp"
#include "taylor_terms.hpp"

namespace rigid_body_sim {
namespace {

/// 1/n, up to the highest degree
template <class T>
constexpr std::array<T, kHighestTaylorDegree + 1> kInverse = [] {
  std::array<T, kHighestTaylorDegree + 1> inverse{};
  for (std::size_t n = 1; n < inverse.size(); ++n) inverse[n] = T(1) / T(n);
  return inverse;
}();

/// The torque of a TaylorPull in principal axes, degree by degree.
template <class T>
class PullRecursion {
 public:
  explicit PullRecursion(const TaylorPull<T>& pull) : pull_(pull) {
    for (auto& torque : torque_W_) torque.setZero();
    torque_W_[1] = vector(pull.linear_W);
    torque_W_[2] = vector(pull.quadratic_W);
  }

  /// The coefficient k of I⁻¹ × the torque in P, from those of the products of q up to k.
  Vector3<T> accelerationOf(std::size_t k, const Lanes<T>& squares, const Lanes<T>& crosses,
                            const Lanes<T>& turns) {
    Matrix3<T>& R = R_[k];
    // as plain numbers: a template deduced from the lanes would take them for aligned to 32 bytes
    T squares_k[4], crosses_k[4], turns_k[4];
    store<T>(squares, squares_k);
    store<T>(crosses, crosses_k);
    store<T>(turns, turns_k);
    setRotationMatrix<T>(k == 0 ? T(1) : T(0), squares_k, crosses_k, turns_k, R);
    if (k + 2 < torque_W_.size())
      torque_W_[k + 2] += vector(pull_.force_W).cross(R * vector(pull_.acceleration_P)) *
                          (kInverse<T>[k + 1] * kInverse<T>[k + 2]);
    Vector3<T> torque_P = Vector3<T>::Zero();
    for (std::size_t i = 1; i <= k; ++i) torque_P += R_[k - i].transpose() * torque_W_[i];
    return torque_P.cwiseProduct(vector(pull_.inv_I));
  }

  /// The coefficient k + 1 of the integral of the torque in world axes.
  void integral(std::size_t k, T (&to)[4]) const {
    for (int i = 0; i < 3; ++i) to[i] = torque_W_[k][i] * kInverse<T>[k + 1];
    to[3] = T(0);
  }

 private:
  static Vector3<T> vector(const T (&v)[3]) { return Vector3<T>(v[0], v[1], v[2]); }

  const TaylorPull<T>& pull_;
  std::array<Matrix3<T>, kHighestTaylorDegree> R_;
  std::array<Vector3<T>, kHighestTaylorDegree> torque_W_;
};

template <class T, bool kPulled>
decltype(auto) pullOf(const TaylorEquations<T>& equations) {
  if constexpr (kPulled)
    return *equations.pull;
  else
    return 0;
}

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

template <class T, bool kTurned, bool kPulled>
RIGID_BODY_SIM_INLINE void expand(const TaylorEquations<T>& equations, std::size_t degree,
                                  TaylorSeries<T>& series) {
  Lanes<T> gyroscopic, steady;
  load<T>(equations.gyroscopic, gyroscopic);
  load<T>(equations.steady, steady);
  std::conditional_t<kPulled, PullRecursion<T>, int> pull(pullOf<T, kPulled>(equations));
  Arranged<T> arranged;
  Products<T> p{};
  Lanes<T> w, q;
  load<T>(series.w[0], w);
  load<T>(series.q[0], q);
  arranged.add(0, w, q);
  const NewestTurn<T> turn(w, arranged);
  const Turning<T> turning(equations, q);
  for (std::size_t k = 0; k < degree; ++k) {
    const T inverse = kInverse<T>[k + 1];
    if (k > 0) arranged.add(k, w, q);
    p.template sum<kTurned>(arranged, series, k);
    Lanes<T> w_dot = p.ww + arranged.w_yzx[0] * arranged.w_zxy[k];
    if (k > 0) w_dot += arranged.w_yzx[k] * arranged.w_zxy[0];
    w_dot = gyroscopic * w_dot;
    if constexpr (kTurned) {
      Lanes<T> older, newest;
      turning.older(p, older);
      turning.newest(q, k, newest);
      if (k == 0) older += steady;
      w_dot = older + (w_dot + newest);
      p.addNewest(arranged, k);
      store<T>(p.squares * inverse, series.squares[k + 1]);
      store<T>(p.crosses * inverse, series.crosses[k + 1]);
      store<T>(p.turns * inverse, series.turns[k + 1]);
    }
    if constexpr (kPulled) {
      const Vector3<T> extra = pull.accelerationOf(k, p.squares, p.crosses, p.turns);
      for (int i = 0; i < 3; ++i) w_dot[i] += extra[i];
      pull.integral(k, series.pull[k + 1]);
    }
    Lanes<T> q_dot;
    turn.q_dot(arranged, p, w, k, q_dot);
    w = w_dot * inverse;
    q = q_dot * inverse;
    store<T>(w, series.w[k + 1]);
    store<T>(q, series.q[k + 1]);
  }
}

template <class T>
RIGID_BODY_SIM_INLINE void expandAsAsked(const TaylorEquations<T>& equations, bool turned,
                                         std::size_t degree, TaylorSeries<T>& series) {
  if (equations.pull)
    expand<T, true, true>(equations, degree, series);
  else if (turned)
    expand<T, true, false>(equations, degree, series);
  else
    expand<T, false, false>(equations, degree, series);
}

/// Horner's rule without the constant term.
template <class T>
RIGID_BODY_SIM_INLINE void evaluate(const TaylorSeries<T>& series, bool turned, std::size_t degree,
                                    T s, TaylorIncrements<T>& increments) {
  Lanes<T> w, q, squares, crosses, turns;
  load<T>(series.w[degree], w);
  load<T>(series.q[degree], q);
  Lanes<T> c = w;  // or GCC warns where it instruments for threads
  for (std::size_t k = degree - 1; k > 0; --k) {
    load<T>(series.w[k], c);
    w = c + w * s;
    load<T>(series.q[k], c);
    q = c + q * s;
  }
  store<T>(w * s, increments.w);
  store<T>(q * s, increments.q);
  if (!turned) return;
  load<T>(series.squares[degree], squares);
  load<T>(series.crosses[degree], crosses);
  load<T>(series.turns[degree], turns);
  for (std::size_t k = degree - 1; k > 0; --k) {
    load<T>(series.squares[k], c);
    squares = c + squares * s;
    load<T>(series.crosses[k], c);
    crosses = c + crosses * s;
    load<T>(series.turns[k], c);
    turns = c + turns * s;
  }
  store<T>(squares * s, increments.squares);
  store<T>(crosses * s, increments.crosses);
  store<T>(turns * s, increments.turns);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void expandWide(const TaylorEquations<double>& equations,
                                                bool turned, std::size_t degree,
                                                TaylorSeries<double>& series) {
  expandAsAsked(equations, turned, degree, series);
}

__attribute__((target("avx2"))) void evaluateWide(const TaylorSeries<double>& series, bool turned,
                                                  std::size_t degree, double s,
                                                  TaylorIncrements<double>& increments) {
  evaluate(series, turned, degree, s, increments);
}

bool hasWideLanes() {
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}
#endif

}  // namespace

template <class T>
void expandTaylorNarrow(const TaylorEquations<T>& equations, bool turned, std::size_t degree,
                        TaylorSeries<T>& series) {
  expandAsAsked(equations, turned, degree, series);
}

template <class T>
void expandTaylor(const TaylorEquations<T>& equations, bool turned, std::size_t degree,
                  TaylorSeries<T>& series) {
#if defined(__x86_64__)
  if constexpr (std::is_same_v<T, double>)
    if (hasWideLanes()) return expandWide(equations, turned, degree, series);
#endif
  expandAsAsked(equations, turned, degree, series);
}

template <class T>
void evaluateTaylor(const TaylorSeries<T>& series, bool turned, std::size_t degree, T s,
                    TaylorIncrements<T>& increments) {
#if defined(__x86_64__)
  if constexpr (std::is_same_v<T, double>)
    if (hasWideLanes()) return evaluateWide(series, turned, degree, s, increments);
#endif
  evaluate(series, turned, degree, s, increments);
}

template void expandTaylor(const TaylorEquations<double>&, bool, std::size_t,
                           TaylorSeries<double>&);
template void expandTaylor(const TaylorEquations<long double>&, bool, std::size_t,
                           TaylorSeries<long double>&);
template void expandTaylorNarrow(const TaylorEquations<double>&, bool, std::size_t,
                                 TaylorSeries<double>&);
template void evaluateTaylor(const TaylorSeries<double>&, bool, std::size_t, double,
                             TaylorIncrements<double>&);
template void evaluateTaylor(const TaylorSeries<long double>&, bool, std::size_t, long double,
                             TaylorIncrements<long double>&);

}  // namespace rigid_body_sim
