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

template <class T>
AsymmetricPath<T>::AsymmetricPath(const ScaledInertia<T>& i, const FreeInvariants<T>& f)
    : first(f.D2 < Wide<T>(0)), a(first ? 0 : 2), turned(f.m(a) < Wide<T>(0)) {
  using std::abs;
  using std::sqrt;
  using W = Wide<T>;
  const W Ia = first ? i.I1 : i.I3, Ib = first ? i.I3 : i.I1;
  const W Ia2 = first ? i.I21 : i.I32, Ib2 = first ? i.I32 : i.I21;  // |I_a − I2|, |I_b − I2|
  const W Da = first ? f.D1 : -f.D3, Db = first ? -f.D3 : f.D1;      // |D_a|, |D_b|
  const W I1I3 = i.I1 * i.I3;
  A = sqrt(Ia * Db / i.I31);
  B = sqrt(Ib * Da / i.I31);
  M = sqrt(i.I2 * Da / Ia2);

  // where on its path m starts; sn and cn from their ratio, never through an angle
  const W sign(turned ? -1 : 1);
  const W s = f.m(1) * B;
  const W c = sign * f.m(2 - a) * M;
  const W norm = sqrt(s * s + c * c);
  sn = s / norm;
  cn = c / norm;
  dn = sign * f.m(a) / A;

  const W lambda_scaled = sqrt(Db * Ia2 / (I1I3 * i.I2));
  C = i.I31 / (lambda_scaled * I1I3);
  lambda = f.rate * lambda_scaled;
  k2 = Da * Ib2 / (Db * Ia2);
  mc = std::min(W(1), abs(f.D2) * i.I31 / (Db * Ia2));
  r = sqrt(i.I2 * i.I31 / (Ib * Ia2));

  // the characteristic nearer to zero leaves the smaller integral beside the secular rate
  const W n = -Ia * Ib2 / (Ib * Ia2);
  const W N = -Ib * Da / (Ia * Db);
  w = sqrt(W(1) - N);
  other_rate = abs(n) <= abs(N);
  nu = other_rate ? n : N;
  const CompleteIntegrals<W> complete = completeIntegrals(mc, nu);
  half_period = W(2) * complete.K;
  rate = f.rate / (other_rate ? Ib : Ia);
  const W per_half_period = W(2) * C * complete.Pi_minus_K;
  const W sigma(first ? 1 : -1);
  angle_per_half_period = sigma * (other_rate ? kPi<W> - per_half_period : per_half_period);
}

namespace {

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
AsymmetricRotation<T>::AsymmetricRotation(const AsymmetricPath<T>& path,
                                          const FreeInvariants<T>& invariants,
                                          const Quaternion<T>& q_WP)
    : lambda_(path.lambda),
      half_period_(path.half_period),
      rate_(path.rate),
      angle_per_half_period_(path.angle_per_half_period),
      magnitude_(invariants.magnitude),
      sigma_(T(path.first ? 1 : -1)),
      amplitude_a_(T(path.A)),
      amplitude_2_(T(path.M)),
      amplitude_b_(T(path.B)),
      start_{T(path.sn), T(path.cn), T(path.dn)},
      jacobi_(path.mc),
      k2_(T(path.k2)),
      nu_(T(path.nu)),
      C_(T(path.C)),
      r_(T(path.r)),
      w_(T(path.w)),
      a_(path.a),
      turned_(path.turned),
      other_rate_(path.other_rate) {
  using W = Wide<T>;
  const W sign(turned_ ? -1 : 1);
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

template struct AsymmetricPath<double>;
template struct AsymmetricPath<long double>;
template class AsymmetricRotation<double>;
template class AsymmetricRotation<long double>;
template struct FreeInvariants<double>;
template struct FreeInvariants<long double>;

}  // namespace rigid_body_sim
