#pragma once

#include "dynamics/rotation/theta_rotation.hpp"
#include "math/pack.hpp"
#include "math/small_angle.hpp"
#include "math/triple.hpp"

/// The evaluation of a ThetaRotation, T: double or a pack of several bodies, with the same bits.
namespace rigid_body_sim {

/// The nearest whole number, of |x| < 2⁵¹.
template <class T>
RIGID_BODY_SIM_INLINE T whole(const T& x) {
  constexpr double kShift = 6755399441055744.0;  // 1.5 · 2⁵²: no digit is left for the fraction
  return (x + kShift) - kShift;
}

/// cos and sin.
template <class T>
struct Phase {
  T c, s;
};

template <class T>
RIGID_BODY_SIM_INLINE Phase<T> sumOf(const Phase<T>& a, const Phase<T>& b) {
  return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}

/// [s] A time as the sum of two numbers of 26 bits (Veltkamp): products with such numbers are
/// exact.
template <class T>
struct SplitTime {
  explicit RIGID_BODY_SIM_INLINE SplitTime(const T& dt) : all(dt) {
    const T scaled = 134217729.0 * dt;  // 2²⁷ + 1
    high = scaled - (scaled - dt);
    low = dt - high;
  }
  T all, high, low;
};

/// The phase `start` + rate · dt [turns], the rate in three parts of which the first two have 26
/// bits: what it has in whole turns costs no digits.
template <class T>
RIGID_BODY_SIM_INLINE Phase<T> phaseAfter(const Triple<T>& rate, const SplitTime<T>& dt,
                                          const T& start) {
  const T coarse = rate.x * dt.high;
  T part = coarse - whole(coarse);
  const T quarters = whole(T(4.0 * part));
  part = part - 0.25 * quarters;
  T fine = (rate.x * dt.low + rate.y * dt.high) + (rate.y * dt.low + rate.z * dt.all) + start;
  fine = fine - whole(fine);
  const T sum = part + fine;
  const T more = whole(T(4.0 * sum));
  constexpr double kTwoPi = 6.283185307179586;
  const T angle = kTwoPi * (sum - 0.25 * more);  // to ±π/4
  const T square = angle * angle;
  const T c = cosine(square), s = angle * sinOverAngle(square);
  // and n quarters of a turn, n = −2 … 2
  T n = quarters + more;
  n = n - 4.0 * whole(T(0.25 * n));
  const T size = absolute(n);
  return sumOf(Phase<T>{c, s}, Phase<T>{1.0 - size, n * (2.0 - size)});
}

/// Theta functions ϑ₁ … ϑ₄ of (z | q), the first two over 2 q^¼, and the two that carry the
/// attitude.
template <class T>
struct ThetaValues {
  T theta_1, theta_2, theta_3, theta_4;
  Phase<T> alpha, beta;
};

/// at(i): the number i of a ThetaRotation. is_first: whether e₁ is circled, not e₃.
template <bool is_first, class T, class Numbers>
RIGID_BODY_SIM_INLINE ThetaValues<T> thetaValues(const Numbers& at, const Phase<T>& z) {
  const Phase<T> z2 = sumOf(z, z), z3 = sumOf(z2, z), z4 = sumOf(z2, z2), z5 = sumOf(z3, z2),
                 z6 = sumOf(z4, z2), z7 = sumOf(z5, z2), z8 = sumOf(z4, z4), z9 = sumOf(z7, z2),
                 z10 = sumOf(z8, z2), z11 = sumOf(z9, z2);
  const T q = at(kNome);
  const T q2 = q * q, q4 = q2 * q2, q6 = q4 * q2, q8 = q4 * q4, q9 = q8 * q, q12 = q6 * q6,
          q16 = q8 * q8, q20 = q16 * q4, q25 = q16 * q9, q30 = q20 * (q4 * q6);
  ThetaValues<T> v;
  const T odd = q * z2.c + (q9 * z6.c + q25 * z10.c), even = q4 * z4.c + q16 * z8.c;
  v.theta_3 = 1.0 + 2.0 * (even + odd);
  v.theta_4 = 1.0 + 2.0 * (even - odd);
  v.theta_1 = z.s + ((q6 * z5.s - q2 * z3.s) + ((q20 * z9.s - q12 * z7.s) - q30 * z11.s));
  v.theta_2 = z.c + ((q6 * z5.c + q2 * z3.c) + ((q20 * z9.c + q12 * z7.c) + q30 * z11.c));
  v.alpha.c =
      1.0 + (at(kEvenReal) * z2.c +
             (at(kEvenReal + 1) * z4.c + (at(kEvenReal + 2) * z6.c + at(kEvenReal + 3) * z8.c)));
  v.alpha.s =
      at(kEvenImaginary) * z2.s + (at(kEvenImaginary + 1) * z4.s +
                                   (at(kEvenImaginary + 2) * z6.s + at(kEvenImaginary + 3) * z8.s));
  const T cosines =
      at(kOddCosines) * z.c +
      (at(kOddCosines + 1) * z3.c + (at(kOddCosines + 2) * z5.c + at(kOddCosines + 3) * z7.c));
  const T sines = at(kOddSines) * z.s + (at(kOddSines + 1) * z3.s +
                                         (at(kOddSines + 2) * z5.s + at(kOddSines + 3) * z7.s));
  v.beta = is_first ? Phase<T>{cosines, sines} : Phase<T>{sines, cosines};
  return v;
}

/// The factor of the attitude that changes, not normalized, and L_P [kg m²/s], dt [s] after the
/// start.
template <bool is_first, class T, class Numbers>
RIGID_BODY_SIM_INLINE void thetaFactor(const Numbers& at, const T& dt, Quad<T>& turn,
                                       Triple<T>& L_P) {
  const SplitTime<T> time(dt);
  const auto tripleAt = [&at](int i) { return Triple<T>{at(i), at(i + 1), at(i + 2)}; };
  const Phase<T> z = phaseAfter(tripleAt(kArgumentRate), time, T(at(kArgumentStart)));
  const Phase<T> phi = phaseAfter(tripleAt(kPhaseRate), time, T(0.0));
  const ThetaValues<T> v = thetaValues<is_first, T>(at, z);
  const T root = 1.0 / squareRoot(v.theta_4);
  const Phase<T> scaled_phi{root * phi.c, root * phi.s};
  const Phase<T> alpha = sumOf(scaled_phi, v.alpha), beta = sumOf(scaled_phi, v.beta);
  const T inverse = root * root;
  const T along = at(kAmplitudes) * (inverse * v.theta_3);
  const T middle = at(kAmplitudes + 1) * (inverse * v.theta_1);
  const T other = at(kAmplitudes + 2) * (inverse * v.theta_2);
  if constexpr (is_first) {
    L_P = {along, middle, other};
    turn = {alpha.s, beta.c, beta.s, alpha.c};
  } else {
    L_P = {other, middle, along};
    turn = {beta.c, beta.s, alpha.s, alpha.c};
  }
}

/// The attitude and L_P [kg m²/s] dt [s] after the start.
template <bool is_first, class T, class Numbers>
RIGID_BODY_SIM_INLINE void thetaMotion(const Numbers& at, const T& dt, Quad<T>& q_WP,
                                       Triple<T>& L_P) {
  Quad<T> turn;
  thetaFactor<is_first>(at, dt, turn, L_P);
  q_WP = product(Quad<T>{at(kBefore), at(kBefore + 1), at(kBefore + 2), at(kBefore + 3)}, turn);
  renormalize(q_WP);
}

}  // namespace rigid_body_sim
