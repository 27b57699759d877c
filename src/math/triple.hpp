#pragma once

#include "math/always_inline.hpp"

/// Vectors and quaternions of which each component is a number or a pack of them, one for each of
/// several bodies. Not Eigen's, and apart from `rotate` and `product` of math/rotation.hpp: all of
/// this is inlined into what is compiled for one instruction set, whatever the compiler prefers.
/// T: double, or a class of packs with + − * / among themselves and with double.
namespace rigid_body_sim {

template <class T>
struct Triple {
  T x, y, z;
};

template <class T>
struct Quad {
  T x, y, z, w;
};

template <class T>
RIGID_BODY_SIM_INLINE Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T>
RIGID_BODY_SIM_INLINE Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// By a number or by a pack.
template <class S, class T>
RIGID_BODY_SIM_INLINE Triple<T> operator*(const S& s, const Triple<T>& v) {
  return {s * v.x, s * v.y, s * v.z};
}

/// Component by component.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> scaled(const Triple<T>& by, const Triple<T>& v) {
  return {by.x * v.x, by.y * v.y, by.z * v.z};
}

template <class T>
RIGID_BODY_SIM_INLINE Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
RIGID_BODY_SIM_INLINE T dot(const Triple<T>& a, const Triple<T>& b) {
  return a.x * b.x + (a.y * b.y + a.z * b.z);
}

template <class T>
RIGID_BODY_SIM_INLINE T squaredNorm(const Quad<T>& q) {
  return (q.x * q.x + q.z * q.z) + (q.y * q.y + q.w * q.w);
}

/// Hamilton's product a b.
template <class T>
RIGID_BODY_SIM_INLINE Quad<T> product(const Quad<T>& a, const Quad<T>& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// R(q) v for a unit quaternion:  v + 2 u × (u × v + w v),  u the vector part.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> rotate(const Quad<T>& q, const Triple<T>& v) {
  const Triple<T> u{q.x, q.y, q.z};
  const Triple<T> t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}

/// R(q)ᵀ v for a unit quaternion.
template <class T>
RIGID_BODY_SIM_INLINE Triple<T> rotateBack(const Quad<T>& q, const Triple<T>& v) {
  const Triple<T> u{q.x, q.y, q.z};
  const Triple<T> t = 2.0 * cross(u, v);
  return v - q.w * t + cross(u, t);
}

/// See renormalize in math/rotation.hpp.
template <class T>
RIGID_BODY_SIM_INLINE void renormalize(Quad<T>& q) {
  const T factor = 0.5 * (3.0 - squaredNorm(q));
  q = {q.x * factor, q.y * factor, q.z * factor, q.w * factor};
}

}  // namespace rigid_body_sim
