#include "dynamics/rotation/asymmetric_rotation.hpp"

#include "dynamics/rotation/shortest_rotation.hpp"

namespace rigid_body_sim {

template <class T>
FreeInvariants<T>::FreeInvariants(const ScaledInertia<T>& inertia, const AngularMomentum<T>& L)
    : magnitude(T(L.magnitude)), rate(L.magnitude / inertia.unit), m(L.direction_P) {
  const Wide<T> T1 = m(0) * m(0) / inertia.I1;
  const Wide<T> T2 = m(1) * m(1) / inertia.I2;
  const Wide<T> T3 = m(2) * m(2) / inertia.I3;
  D1 = T2 * inertia.I21 + T3 * inertia.I31;
  D2 = T3 * inertia.I32 - T1 * inertia.I21;
  D3 = -(T1 * inertia.I31 + T2 * inertia.I32);
}

namespace {

/// What the constants of the motion are made of, in terms of the axis circled and the other one.
template <class T>
struct CircledAxis {
  CircledAxis(const ScaledInertia<T>& i, const FreeInvariants<T>& f)
      : first(f.D2 < Wide<T>(0)),
        Ia(first ? i.I1 : i.I3),
        Ib(first ? i.I3 : i.I1),
        Ia2(first ? i.I21 : i.I32),
        Ib2(first ? i.I32 : i.I21),
        Da(first ? f.D1 : -f.D3),
        Db(first ? -f.D3 : f.D1) {}

  bool first;
  Wide<T> Ia, Ib;
  Wide<T> Ia2, Ib2;  ///< |I_a − I2|, |I_b − I2|
  Wide<T> Da, Db;    ///< |D_a|, |D_b|

  /// 1 − k²
  Wide<T> complementaryParameter(const ScaledInertia<T>& i, const FreeInvariants<T>& f) const {
    using std::abs;
    return std::min(Wide<T>(1), abs(f.D2) * i.I31 / (Db * Ia2));
  }
};

/// The functions at s + v. The denominator 1 − k² sn²s sn²v is written cn²s + sn²s dn²v, which does
/// not cancel, and all is scaled by its greater root, so that near the separatrix nothing
/// underflows. Source: DLMF 22.8.1 to 22.8.3.
template <class T>
JacobiValues<T> sumArgument(const JacobiValues<T>& s, const JacobiValues<T>& v, T k2) {
  using std::abs;
  using std::max;
  const T scale = T(1) / max(abs(s.cn), v.dn);
  const T s_cn = scale * s.cn, s_dn = scale * s.dn, v_cn = scale * v.cn, v_dn = scale * v.dn;
  const T inverse = T(1) / (s_cn * s_cn + s.sn * s.sn * v_dn * v_dn);
  return {inverse * (s.sn * v_cn * v_dn + v.sn * s_cn * s_dn),
          inverse * (s_cn * v_cn - s.sn * s_dn * v.sn * v_dn),
          inverse * (s_dn * v_dn - k2 * s.sn * s_cn * v.sn * v_cn)};
}

}  // namespace

template <class T>
AsymmetricRotation<T>::AsymmetricRotation(const ScaledInertia<T>& inertia,
                                          const FreeInvariants<T>& invariants,
                                          const Quaternion<T>& q_WP)
    : magnitude_(invariants.magnitude),
      jacobi_(CircledAxis<T>(inertia, invariants).complementaryParameter(inertia, invariants)) {
  using std::abs;
  using std::sqrt;
  using W = Wide<T>;
  const CircledAxis<T> axis(inertia, invariants);
  a_ = axis.first ? 0 : 2;
  sigma_ = T(axis.first ? 1 : -1);
  const W I1I3 = inertia.I1 * inertia.I3;
  const W A = sqrt(axis.Ia * axis.Db / inertia.I31);
  const W B = sqrt(axis.Ib * axis.Da / inertia.I31);
  const W M = sqrt(inertia.I2 * axis.Da / axis.Ia2);
  amplitude_a_ = T(A);
  amplitude_2_ = T(M);
  amplitude_b_ = T(B);

  // where on its path m starts; sn and cn from their ratio, never through an angle
  turned_ = invariants.m(a_) < W(0);
  const W sign(turned_ ? -1 : 1);
  const W s = invariants.m(1) * B;
  const W c = sign * invariants.m(2 - a_) * M;
  const W norm = sqrt(s * s + c * c);
  start_ = {T(s / norm), T(c / norm), T(sign * invariants.m(a_) / A)};

  const W lambda = sqrt(axis.Db * axis.Ia2 / (I1I3 * inertia.I2));
  const W C = inertia.I31 / (lambda * I1I3);
  lambda_ = invariants.rate * lambda;
  k2_ = T(axis.Da * axis.Ib2 / (axis.Db * axis.Ia2));
  C_ = T(C);
  r_ = T(sqrt(inertia.I2 * inertia.I31 / (axis.Ib * axis.Ia2)));

  // the characteristic nearer to zero leaves the smaller integral beside the secular rate
  const W n = -axis.Ia * axis.Ib2 / (axis.Ib * axis.Ia2);
  const W N = -axis.Ib * axis.Da / (axis.Ia * axis.Db);
  w_ = T(sqrt(W(1) - N));
  other_rate_ = abs(n) <= abs(N);
  const W nu = other_rate_ ? n : N;
  nu_ = T(nu);
  const W mc = axis.complementaryParameter(inertia, invariants);
  const CompleteIntegrals<W> complete = completeIntegrals(mc, nu);
  half_period_ = W(2) * complete.K;
  rate_ = invariants.rate / (other_rate_ ? axis.Ib : axis.Ia);
  const W per_half_period = W(2) * C * complete.Pi_minus_K;
  angle_per_half_period_ = W(sigma_) * (other_rate_ ? kPi<W> - per_half_period : per_half_period);

  const Vector3<W> m0(sign * invariants.m(0), invariants.m(1), sign * invariants.m(2));
  const Quaternion<T> back(shortestRotation<T>(a_, Vector3<T>(m0.template cast<T>())).conjugate());
  before_ = product(q_WP, turned_ ? halfTurned(back) : back);
}

template <class T>
T AsymmetricRotation<T>::oscillation(const JacobiValues<T>& v, const JacobiValues<T>& u) const {
  using std::atan2;
  const JacobiValues<T>& s = start_;
  // Π(ν; v) − v, and what Π(ν; u₀ + v) has beyond Π(ν; u₀) + Π(ν; v)
  const T third = C_ * incompletePiMinusF(v, k2_, nu_);
  const T addition = atan2(nu_ * C_ * s.sn * v.sn * u.sn,
                           T(1) - nu_ * u.sn * u.sn + nu_ * s.sn * v.sn * u.cn * u.dn);
  if (other_rate_) {
    // turn of cn + i r sn from u₀ to u
    const T im = r_ * (u.sn * s.cn - s.sn * u.cn);
    const T re = u.cn * s.cn + r_ * r_ * u.sn * s.sn;
    return atan2(im, re) - third - addition;
  }
  // turn of (cn + i r sn)(cn dn − i r √(1−N) sn) from u₀ to u;  dn − √(1−N) without cancellation
  const auto real = [this](const JacobiValues<T>& j) {
    return j.cn * j.cn * j.dn + r_ * r_ * w_ * j.sn * j.sn;
  };
  const auto imaginary = [this](const JacobiValues<T>& j) {
    return r_ * j.sn * j.cn * (nu_ - k2_ * j.sn * j.sn) / (j.dn + w_);
  };
  const T re = real(u) * real(s) + imaginary(u) * imaginary(s);
  const T im = imaginary(u) * real(s) - imaginary(s) * real(u);
  return atan2(im, re) + third + addition;
}

template <class T>
RotationState<T> AsymmetricRotation<T>::at(T dt) const {
  using std::abs;
  using std::floor;
  using std::rint;
  using W = Wide<T>;
  // λ dt = v + half_periods 2K, |v| ≤ K
  W argument = lambda_ * W(dt);
  W half_periods(0);
  if (abs(argument) > half_period_ / W(2)) {
    half_periods = rint(argument / half_period_);
    argument -= half_periods * half_period_;
  }
  const JacobiValues<T> v = jacobi_.at(T(argument));

  const JacobiValues<T> u = sumArgument(start_, v, k2_);
  const W psi =
      rate_ * W(dt) + half_periods * angle_per_half_period_ + W(sigma_ * oscillation(v, u));

  // sn and cn change sign over a half period
  const T parity(W(2) * floor(half_periods / W(2)) == half_periods ? 1 : -1);
  Vector3<T> m;
  m(a_) = amplitude_a_ * u.dn;
  m(1) = parity * amplitude_2_ * u.sn;
  m(2 - a_) = parity * amplitude_b_ * u.cn;
  return turnedState<T>(before_, turned_, a_, psi, m, magnitude_);
}

template class AsymmetricRotation<double>;
template class AsymmetricRotation<long double>;
template struct FreeInvariants<double>;
template struct FreeInvariants<long double>;

}  // namespace rigid_body_sim
