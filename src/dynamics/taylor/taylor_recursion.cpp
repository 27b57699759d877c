#include "dynamics/taylor/taylor_recursion.hpp"

#include <type_traits>

#include "dynamics/taylor/lanes.hpp"
#include "dynamics/taylor/taylor_drive_recursion.hpp"
#include "dynamics/taylor/taylor_products.hpp"
#include "dynamics/taylor/taylor_pull.hpp"
#include "dynamics/taylor/taylor_terms.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kNoDrive = 0;

template <class T, bool kPulled>
decltype(auto) pullOf(const TaylorEquations<T>& equations) {
  if constexpr (kPulled)
    return *equations.pull;
  else
    return 0;
}

/// Turns: whether moments turn with the attitude; else no more than the products of q are wanted.
/// drive: a TaylorDrive, or anything where there is none.
template <class T, bool kTurned, bool kTurns, bool kPulled, bool kDriven = false,
          class Drive = const int>
RIGID_BODY_SIM_INLINE void expand(const TaylorEquations<T>& equations, std::size_t degree,
                                  TaylorSeries<T>& series, Drive& given_drive = kNoDrive) {
  Lanes<T> gyroscopic, steady;
  load<T>(equations.gyroscopic, gyroscopic);
  load<T>(equations.steady, steady);
  [[maybe_unused]] std::conditional_t<kPulled, PullRecursion<T>, int> pull(
      pullOf<T, kPulled>(equations));
  [[maybe_unused]] std::conditional_t<kDriven, DriveRecursion<T>, int> drive(given_drive);
  ArrangedSeries<T> arranged;
  TwoProducts<T, kTurned> products;
  Products<T> p;
  Lanes<T> w, q;
  load<T>(series.w[0], w);
  load<T>(series.q[0], q);
  arranged.template put<kTurned>(0, w, q);
  [[maybe_unused]] std::conditional_t<kTurns, Turning<T>, NoTurning> turning(equations, q);
  for (std::size_t k = 0; k < degree; ++k) {
    const T inverse = kInverse<T>[k + 1];
    if (k > 0) arranged.template put<kTurned>(k, w, q);
    if (k % 2 == 0)
      products.begin(arranged, k, p);
    else
      products.end(arranged, k - 1, p);
    Lanes<T> w_dot = p.of_w[0] + arranged[0].left[0] * arranged[k].right[0];
    if (k > 0) w_dot += arranged[k].left[0] * arranged[0].right[0];
    w_dot = gyroscopic * w_dot;
    if constexpr (kTurns) {
      Lanes<T> older, newest;
      turning.older(p, older);
      turning.newest(q, k, newest);
      if (k == 0) older += steady;
      w_dot = older + (w_dot + newest);
    } else if (kTurned && k == 0) {
      w_dot += steady;
    }
    if constexpr (kTurned) {
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
    if constexpr (kDriven) {
      drive.addAcceleration(arranged, k, w_dot);
      drive.turn(k, p, inverse);
      if constexpr (kPulled) pull.accelerate(k, drive.pushed());
    }
    Lanes<T> q_dot;
    turnOf(arranged, p, k, q_dot);
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
    expand<T, true, true, true>(equations, degree, series);
  else if (turned && equations.turns)
    expand<T, true, true, false>(equations, degree, series);
  else if (turned)
    expand<T, true, false, false>(equations, degree, series);
  else
    expand<T, false, false, false>(equations, degree, series);
}

template <class T>
RIGID_BODY_SIM_INLINE void expandDrivenAsAsked(const TaylorEquations<T>& equations,
                                               TaylorDrive<T>& drive, std::size_t degree,
                                               TaylorSeries<T>& series) {
  if (equations.pull)
    expand<T, true, true, true, true>(equations, degree, series, drive);
  else
    expand<T, true, true, false, true>(equations, degree, series, drive);
}

/// Horner's rule without the constant term, of all series in one pass: each waits for its own sum
/// only. Of ω and q, or also of the products of components of q (kSeries 5) and of their integrals.
template <class T, int kSeries, bool kIntegrated>
RIGID_BODY_SIM_INLINE void evaluateSeries(const TaylorSeries<T>& series, std::size_t degree, T s,
                                          TaylorIncrements<T>& gain) {
  constexpr int kMotion = 2;
  using Coefficient = const T(*)[4];
  const Coefficient of[] = {series.w, series.q, series.squares, series.crosses, series.turns};
  Lanes<T> sum[kSeries], c;
  [[maybe_unused]] Lanes<T> whole[3];  // of the integrals: GCC 9 warns where there are none
  for (int j = 0; j < kSeries; ++j) {
    load<T>(of[j][degree], sum[j]);
    if constexpr (kIntegrated)
      if (j >= kMotion) whole[j - kMotion] = sum[j] * kInverse<T>[degree + 1];
  }
  c = sum[0];  // or GCC warns where it instruments for threads
  for (std::size_t k = degree - 1; k > 0; --k)
    for (int j = 0; j < kSeries; ++j) {
      load<T>(of[j][k], c);
      sum[j] = c + sum[j] * s;
      if constexpr (kIntegrated)
        if (j >= kMotion) whole[j - kMotion] = c * kInverse<T>[k + 1] + whole[j - kMotion] * s;
    }
  store<T>(sum[0] * s, gain.w);
  store<T>(sum[1] * s, gain.q);
  if constexpr (kSeries > kMotion) {
    store<T>(sum[2] * s, gain.squares);
    store<T>(sum[3] * s, gain.crosses);
    store<T>(sum[4] * s, gain.turns);
  }
  if constexpr (kIntegrated) {
    store<T>(whole[0] * (s * s), gain.integrals.squares);
    store<T>(whole[1] * (s * s), gain.integrals.crosses);
    store<T>(whole[2] * (s * s), gain.integrals.turns);
  }
}

template <class T>
RIGID_BODY_SIM_INLINE void evaluate(const TaylorSeries<T>& series, TaylorGains wanted,
                                    std::size_t degree, T s, TaylorIncrements<T>& increments) {
  if (wanted == TaylorGains::kMotion)
    evaluateSeries<T, 2, false>(series, degree, s, increments);
  else if (wanted == TaylorGains::kProducts)
    evaluateSeries<T, 5, false>(series, degree, s, increments);
  else
    evaluateSeries<T, 5, true>(series, degree, s, increments);
}

#if defined(__x86_64__)
// clang 14 spills wide registers to a stack that it has not aligned for them, unless it is told to
#if defined(__clang__)
#define RIGID_BODY_SIM_WIDE __attribute__((target("avx2"), force_align_arg_pointer))
#else
#define RIGID_BODY_SIM_WIDE __attribute__((target("avx2")))
#endif
RIGID_BODY_SIM_WIDE void expandWide(const TaylorEquations<double>& equations, bool turned,
                                    std::size_t degree, TaylorSeries<double>& series) {
  expandAsAsked(equations, turned, degree, series);
}

RIGID_BODY_SIM_WIDE void expandDrivenWide(const TaylorEquations<double>& equations,
                                          TaylorDrive<double>& drive, std::size_t degree,
                                          TaylorSeries<double>& series) {
  expandDrivenAsAsked(equations, drive, degree, series);
}

RIGID_BODY_SIM_WIDE void evaluateWide(const TaylorSeries<double>& series, TaylorGains wanted,
                                      std::size_t degree, double s,
                                      TaylorIncrements<double>& increments) {
  evaluate(series, wanted, degree, s, increments);
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
void expandDriven(const TaylorEquations<T>& equations, TaylorDrive<T>& drive, std::size_t degree,
                  TaylorSeries<T>& series) {
#if defined(__x86_64__)
  if constexpr (std::is_same_v<T, double>)
    if (hasWideLanes()) return expandDrivenWide(equations, drive, degree, series);
#endif
  expandDrivenAsAsked(equations, drive, degree, series);
}

template <class T>
void evaluateTaylor(const TaylorSeries<T>& series, TaylorGains wanted, std::size_t degree, T s,
                    TaylorIncrements<T>& increments) {
#if defined(__x86_64__)
  if constexpr (std::is_same_v<T, double>)
    if (hasWideLanes()) return evaluateWide(series, wanted, degree, s, increments);
#endif
  evaluate(series, wanted, degree, s, increments);
}

template void expandTaylor(const TaylorEquations<double>&, bool, std::size_t,
                           TaylorSeries<double>&);
template void expandTaylor(const TaylorEquations<long double>&, bool, std::size_t,
                           TaylorSeries<long double>&);
template void expandDriven(const TaylorEquations<double>&, TaylorDrive<double>&, std::size_t,
                           TaylorSeries<double>&);
template void expandDriven(const TaylorEquations<long double>&, TaylorDrive<long double>&,
                           std::size_t, TaylorSeries<long double>&);
template void expandTaylorNarrow(const TaylorEquations<double>&, bool, std::size_t,
                                 TaylorSeries<double>&);
template void evaluateTaylor(const TaylorSeries<double>&, TaylorGains, std::size_t, double,
                             TaylorIncrements<double>&);
template void evaluateTaylor(const TaylorSeries<long double>&, TaylorGains, std::size_t,
                             long double, TaylorIncrements<long double>&);

}  // namespace rigid_body_sim
