#pragma once

#include <cmath>
#include <type_traits>

#include <rigid_body_sim/dynamics/state.hpp>

#include "math/small_angle.hpp"
#include "math/triple.hpp"

/// Kernels of motion without wrenches, and of impulses. The methods call them for one body, T =
/// double; packs for many (dynamics/packs), with the same bits.
namespace rigid_body_sim {

/// Whether an angle is too great for the polynomials. That of a body in a pack never is.
template <class T>
RIGID_BODY_SIM_INLINE bool isBeyondSmall(const T& square) {
  if constexpr (std::is_same_v<T, double>)
    return !(square <= kSmallAngleSquared);
  else
    return false;
}

/// The rotation by |theta| [rad] about theta.
template <class T>
RIGID_BODY_SIM_INLINE Quad<T> turnBy(const Triple<T>& theta) {
  const T square = 0.25 * dot(theta, theta);
  if constexpr (std::is_same_v<T, double>) {
    if (isBeyondSmall(square)) {
      const Quaterniond q = rotationExp(Vector3d(theta.x, theta.y, theta.z));
      return {q.x(), q.y(), q.z(), q.w()};
    }
  }
  const T s = 0.5 * sinOverAngle(square);
  return {s * theta.x, s * theta.y, s * theta.z, cosine(square)};
}

/// Flow of ½ k L_i² over h: the body turns by h k L_i about its axis i, so L turns back. i, j, k:
/// the axes in cyclic order; q: the attitude, of which q_i, q_j, q_k belong to them.
template <class T>
RIGID_BODY_SIM_INLINE void turnAboutAxis(const T& hk, const T& L_i, T& L_j, T& L_k, T& q_i, T& q_j,
                                         T& q_k, T& q_w) {
  const T half = 0.5 * hk * L_i;
  const T square = half * half;
  T s, c;
  if (isBeyondSmall(square)) {
    if constexpr (std::is_same_v<T, double>) {
      s = std::sin(half);
      c = std::cos(half);
    }
  } else {
    s = half * sinOverAngle(square);
    c = cosine(square);
  }
  const T S = 2.0 * s * c, C = 1.0 - 2.0 * s * s;
  const T L = L_j;
  L_j = C * L + S * L_k;
  L_k = C * L_k - S * L;
  // q * (c, s e_i)
  const T i = q_i, j = q_j, k = q_k, w = q_w;
  q_i = c * i + s * w;
  q_j = c * j + s * k;
  q_k = c * k - s * j;
  q_w = c * w - s * i;
}

/// The last part of a free rotation that is split (RotationSplit): about L in the world.
template <class T>
RIGID_BODY_SIM_INLINE void turnInWorld(const Triple<T>& theta, Quad<T>& q) {
  q = product(turnBy(theta), q);
  renormalize(q);
}

/// The update of the source lecture: the body turns by |ω| h about ω = I⁻¹ L, and L_P follows from
/// L_W, which stays. First order.
template <class T>
RIGID_BODY_SIM_INLINE void driftAlongOmega(const Triple<T>& inv_I, double h, const Triple<T>& L_W,
                                           Quad<T>& q, Triple<T>& L_P) {
  q = product(q, turnBy(h * scaled(inv_I, L_P)));
  renormalize(q);
  L_P = rotateBack(q, L_W);
}

/// Free rotation over h to fourth order by one exponential, L_W untouched: the Magnus expansion of
/// the body's angular velocity, with w₁, w₂, w₃ its derivatives at the start,
///   θ = h w + h²/2 w₁ + h³/6 w₂ + h⁴/24 w₃ + h³/12 w × w₁ + h⁴/24 w × w₂.
/// Source: Iserles, Munthe-Kaas, Nørsett & Zanna, Acta Numerica 9 (2000) 215.
template <class T>
RIGID_BODY_SIM_INLINE void driftMagnus(const Triple<T>& inv_I, double h, Quad<T>& q,
                                       Triple<T>& L_P) {
  const Triple<T> m = L_P;
  const Triple<T> w = scaled(inv_I, m);
  const Triple<T> m1 = cross(m, w);
  const Triple<T> w1 = scaled(inv_I, m1);
  const Triple<T> m2 = cross(m1, w) + cross(m, w1);
  const Triple<T> w2 = scaled(inv_I, m2);
  const Triple<T> m3 = cross(m2, w) + 2.0 * cross(m1, w1) + cross(m, w2);
  const Triple<T> w3 = scaled(inv_I, m3);
  const Triple<T> theta = h * (w + h / 2 * (w1 + h / 3 * (w2 + h / 4 * w3))) +
                          h * h * h / 12 * (cross(w, w1) + h / 2 * cross(w, w2));
  const Quad<T> turn = turnBy(theta);
  L_P = rotateBack(turn, L_P);
  q = product(q, turn);
  renormalize(q);
}

/// [1/s²] ω·L/I₁ − |ω|², twice the growth of Claim kFeedsLeastAxis; moments are ascending.
template <class T>
RIGID_BODY_SIM_INLINE T leastAxisExcess(const Triple<T>& inv_I, const Triple<T>& L_P) {
  const Triple<T> w_P = scaled(inv_I, L_P);
  return dot(w_P, L_P) * inv_I.x - dot(w_P, w_P);
}

/// x += d with the part that x is too coarse to hold kept in x_low (Neumaier).
template <class T>
RIGID_BODY_SIM_INLINE void moveBy(const T& d, T& x, T& x_low) {
  const T step = d + x_low;
  const T sum = x + step;
  const T kept = sum - x;
  x_low = (x - (sum - kept)) + (step - kept);
  x = sum;
}

/// (I₂ − I₃) ω₂ ω₃ and so on: L × ω by differences of moments. Where two of them are equal, nothing
/// is left for rounding to blow up over the small moment of a needle.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> gyroscopicTorque(const Triple<T>& differences, const Triple<T>& w) {
  return {differences.x * w.y * w.z, differences.y * w.z * w.x, differences.z * w.x * w.y};
}

inline Triple<double> tripleOf(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Quad<double> quadOf(const Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline Vector3d vectorOf(const Triple<double>& v) { return {v.x, v.y, v.z}; }
inline Quaterniond quaternionOf(const Quad<double>& q) { return {q.w, q.x, q.y, q.z}; }

/// turnAboutAxis of a body about its axis 0 … 2.
inline void turnAboutAxis(int axis, double hk, BodyState& s) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  auto& q = s.q_WP.coeffs();
  turnAboutAxis(hk, s.L_P(axis), s.L_P(j), s.L_P(k), q(axis), q(j), q(k), q(3));
}

/// Free rotation over h to second order: symplectic, reversible, L_W untouched; exact when two
/// moments are equal.
inline void driftRotation(const RotationSplit<double>& split, double h, BodyState& s) {
  turnAboutAxis(split.a, 0.5 * h * split.k_a, s);
  turnAboutAxis(split.b, h * split.k_b, s);
  turnAboutAxis(split.a, 0.5 * h * split.k_a, s);
  Quad<double> q = quadOf(s.q_WP);
  turnInWorld(h * split.inv_I_r * tripleOf(s.L_W), q);
  s.q_WP = quaternionOf(q);
}

inline void driftAlongOmega(const Vector3d& inv_I, double h, BodyState& s) {
  Quad<double> q = quadOf(s.q_WP);
  Triple<double> L_P = tripleOf(s.L_P);
  driftAlongOmega(tripleOf(inv_I), h, tripleOf(s.L_W), q, L_P);
  s.q_WP = quaternionOf(q);
  s.L_P = vectorOf(L_P);
}

inline void driftMagnus(const Vector3d& inv_I, double h, BodyState& s) {
  Quad<double> q = quadOf(s.q_WP);
  Triple<double> L_P = tripleOf(s.L_P);
  driftMagnus(tripleOf(inv_I), h, q, L_P);
  s.q_WP = quaternionOf(q);
  s.L_P = vectorOf(L_P);
}

inline void moveBy(const Vector3d& d, BodyState& s) {
  for (int i = 0; i < 3; ++i) moveBy(d(i), s.x_W(i), s.x_low_W(i));
}

/// x += h p/m
inline void driftPosition(double mass, double h, BodyState& s) {
  moveBy(Vector3d(h / mass * s.p_W), s);
}

/// Impulse of a wrench over h at fixed place and attitude:  p += h f,  L += h τ.
inline void kick(const Vector3d& f_W, const Vector3d& tau_W, const Vector3d& tau_P, double h,
                 BodyState& s) {
  s.p_W += h * f_W;
  s.L_W += h * (tau_W + rotate(s.q_WP, tau_P));
  s.L_P += h * (rotateBack(s.q_WP, tau_W) + tau_P);
}

}  // namespace rigid_body_sim
