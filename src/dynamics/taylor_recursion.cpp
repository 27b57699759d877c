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

/// The coefficient k of each product: sums over coefficients whose degrees add up to k.
template <class T>
struct Products {
  Lanes<T> ww;                ///< (ω₂ ω₃, ω₃ ω₁, ω₁ ω₂)
  Lanes<T> qw_x, qw_y, qw_z;  ///< of q with ω₁, ω₂, ω₃, but for signs
  Lanes<T> squares, crosses, turns;

  RIGID_BODY_SIM_INLINE void clear() {
    set<T>(0, 0, 0, 0, ww);
    qw_x = qw_y = qw_z = squares = crosses = turns = ww;
  }

  template <bool kTurned>
  RIGID_BODY_SIM_INLINE void add(const Arranged<T>& a, const TaylorSeries<T>& series, std::size_t i,
                                 std::size_t j) {
    ww += a.w_yzx[i] * a.w_zxy[j];
    qw_x += a.q_x[i] * series.w[j][0];
    qw_y += a.q_y[i] * series.w[j][1];
    qw_z += a.q_z[i] * series.w[j][2];
    if (!kTurned) return;
    crosses += a.q[i] * a.q_yzx[j];
    turns += a.q[i] * series.q[j][3];
  }

  /// All of them. The newest coefficients come last: the sums of the others need not wait for them.
  template <bool kTurned>
  RIGID_BODY_SIM_INLINE void sum(const Arranged<T>& a, const TaylorSeries<T>& series,
                                 std::size_t k) {
    clear();
    for (std::size_t i = 1; i < k; ++i) add<kTurned>(a, series, i, k - i);
    if (kTurned) {
      for (std::size_t i = 1; 2 * i < k; ++i) squares += a.q[i] * a.q[k - i];
      squares = squares + squares;
      if (k > 0 && k % 2 == 0) squares += a.q[k / 2] * a.q[k / 2];
    }
    add<kTurned>(a, series, 0, k);
    if (kTurned) squares += a.q[0] * a.q[k];
    if (k == 0) return;
    add<kTurned>(a, series, k, 0);
    if (kTurned) squares += a.q[0] * a.q[k];
  }
};

template <class T, bool kTurned, bool kPulled>
RIGID_BODY_SIM_INLINE void expand(const TaylorEquations<T>& equations, std::size_t degree,
                                  TaylorSeries<T>& series) {
  Lanes<T> gyroscopic, steady, sign_x, sign_y, sign_z, turning[9];
  load<T>(equations.gyroscopic, gyroscopic);
  load<T>(equations.steady, steady);
  set<T>(1, 1, -1, -1, sign_x);
  set<T>(-1, 1, 1, -1, sign_y);
  set<T>(1, -1, 1, -1, sign_z);
  if (kTurned)
    for (int j = 0; j < 9; ++j) load<T>(equations.turning[j], turning[j]);
  std::conditional_t<kPulled, PullRecursion<T>, int> pull(pullOf<T, kPulled>(equations));
  Arranged<T> arranged;
  Products<T> p{};
  Lanes<T> w, q;
  load<T>(series.w[0], w);
  load<T>(series.q[0], q);
  for (std::size_t k = 0; k < degree; ++k) {
    arranged.add(k, w, q);
    p.template sum<kTurned>(arranged, series, k);
    const T inverse = kInverse<T>[k + 1];
    Lanes<T> w_dot = gyroscopic * p.ww;
    if (kTurned) {
      if (k == 0) w_dot += steady;
      w_dot += ((turning[0] * p.squares[0] + turning[1] * p.squares[1]) +
                (turning[2] * p.squares[2] + turning[3] * p.crosses[0])) +
               ((turning[4] * p.crosses[1] + turning[5] * p.crosses[2]) +
                (turning[6] * p.turns[0] + turning[7] * p.turns[1])) +
               turning[8] * p.turns[2];
      store<T>(p.squares * inverse, series.squares[k + 1]);
      store<T>(p.crosses * inverse, series.crosses[k + 1]);
      store<T>(p.turns * inverse, series.turns[k + 1]);
    }
    if constexpr (kPulled) {
      const Vector3<T> extra = pull.accelerationOf(k, p.squares, p.crosses, p.turns);
      for (int i = 0; i < 3; ++i) w_dot[i] += extra[i];
      pull.integral(k, series.pull[k + 1]);
    }
    w = w_dot * inverse;
    q = (p.qw_x * sign_x + (p.qw_y * sign_y + p.qw_z * sign_z)) * (inverse / T(2));
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
