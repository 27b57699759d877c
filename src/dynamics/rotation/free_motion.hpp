#pragma once

#include <cmath>

#include <rigid_body_sim/dynamics/state.hpp>

#include "math/two_sum.hpp"

/// Kernels of motion without wrenches and of impulses, templates on the scalar.
namespace rigid_body_sim {

/// Flow of ½ k L_axis² over h: the body turns by h k L_axis about its own axis, so L_P turns back.
template <class T>
void turnAboutAxis(int axis, T hk, Quaternion<T>& q, Vector3<T>& L_P) {
  using std::cos;
  using std::sin;
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const T half = T(0.5) * hk * L_P(axis);
  const T s = sin(half), c = cos(half);
  const T S = T(2) * s * c, C = T(1) - T(2) * s * s;
  const T L_j = L_P(j);
  L_P(j) = C * L_j + S * L_P(k);
  L_P(k) = C * L_P(k) - S * L_j;
  // q * (c, s e_axis), coefficients in the order x, y, z, w
  const T q_i = q.coeffs()(axis), q_j = q.coeffs()(j), q_k = q.coeffs()(k), w = q.w();
  q.coeffs()(axis) = c * q_i + s * w;
  q.coeffs()(j) = c * q_j + s * q_k;
  q.coeffs()(k) = c * q_k - s * q_j;
  q.w() = c * w - s * q_i;
}

/// Free rotation over h to second order: symplectic, reversible, L_W untouched; exact when two
/// moments are equal.
template <class T>
void driftRotation(const RotationSplit<T>& split, T h, BodyStateT<T>& s) {
  turnAboutAxis(split.a, T(0.5) * h * split.k_a, s.q_WP, s.L_P);
  turnAboutAxis(split.b, h * split.k_b, s.q_WP, s.L_P);
  turnAboutAxis(split.a, T(0.5) * h * split.k_a, s.q_WP, s.L_P);
  s.q_WP = product(rotationExp(Vector3<T>(h * split.inv_I_r * s.L_W)), s.q_WP);
  renormalize(s.q_WP);
}

/// Free rotation over h to fourth order by one exponential, L_W untouched: the Magnus expansion of
/// the body's angular velocity, with w₁, w₂, w₃ its derivatives at the start,
///   θ = h w + h²/2 w₁ + h³/6 w₂ + h⁴/24 w₃ + h³/12 w × w₁ + h⁴/24 w × w₂.
/// Source: Iserles, Munthe-Kaas, Nørsett & Zanna, Acta Numerica 9 (2000) 215.
template <class T>
void driftMagnus(const Vector3<T>& inv_I, T h, BodyStateT<T>& s) {
  const Vector3<T>& m = s.L_P;
  const Vector3<T> w = inv_I.cwiseProduct(m);
  const Vector3<T> m1 = m.cross(w);
  const Vector3<T> w1 = inv_I.cwiseProduct(m1);
  const Vector3<T> m2 = m1.cross(w) + m.cross(w1);
  const Vector3<T> w2 = inv_I.cwiseProduct(m2);
  const Vector3<T> m3 = m2.cross(w) + T(2) * m1.cross(w1) + m.cross(w2);
  const Vector3<T> w3 = inv_I.cwiseProduct(m3);
  const Vector3<T> theta = h * (w + h / T(2) * (w1 + h / T(3) * (w2 + h / T(4) * w3))) +
                           h * h * h / T(12) * (w.cross(w1) + h / T(2) * w.cross(w2));
  const Quaternion<T> turn = rotationExp(theta);
  s.L_P = rotateBack(turn, s.L_P);
  s.q_WP = product(s.q_WP, turn);
  renormalize(s.q_WP);
}

/// x += d with the part that x_W is too coarse to hold kept in x_low_W (Neumaier).
template <class T>
void moveBy(const Vector3<T>& d, BodyStateT<T>& s) {
  s.x_W = twoSum(s.x_W, Vector3<T>(d + s.x_low_W), s.x_low_W);
}

/// x += h p/m
template <class T>
void driftPosition(T mass, T h, BodyStateT<T>& s) {
  moveBy(Vector3<T>(h / mass * s.p_W), s);
}

/// Impulse of a wrench over h at fixed place and attitude:  p += h f,  L += h τ.
template <class T>
void kick(const Vector3<T>& f_W, const Vector3<T>& tau_W, const Vector3<T>& tau_P, T h,
          BodyStateT<T>& s) {
  s.p_W += h * f_W;
  s.L_W += h * (tau_W + rotate(s.q_WP, tau_P));
  s.L_P += h * (rotateBack(s.q_WP, tau_W) + tau_P);
}

}  // namespace rigid_body_sim
