#pragma once

#include "dynamics/rotation/rotation_state.hpp"
#include "math/elliptic.hpp"

namespace rigid_body_sim {

/// The invariants of the free motion that do not cancel, in units of the magnitude of L and of the
/// greatest moment: with T the kinetic energy, D_j = 1 − 2T I_j, each written as a sum over the two
/// other components.
template <class T>
struct FreeInvariants {
  FreeInvariants(const ScaledInertia<T>& inertia, const AngularMomentum<T>& L);

  T magnitude;         ///< [kg m²/s] of L
  Wide<T> rate;        ///< [1/s] magnitude over unit of inertia
  Vector3<Wide<T>> m;  ///< direction of L_P
  Wide<T> D1;          ///< ≥ 0
  Wide<T> D2;          ///< its sign says about which axis m circles
  Wide<T> D3;          ///< ≤ 0
};

/// The constants of the path that m, the unit vector along L_P, takes off the principal axes and
/// off the separatrix, and where on it m starts; see AsymmetricRotation.
template <class T>
struct AsymmetricPath {
  AsymmetricPath(const ScaledInertia<T>& inertia, const FreeInvariants<T>& invariants);

  bool first;           ///< whether m circles e₁, not e₃
  int a;                ///< index of the axis circled, 0 or 2
  bool turned;          ///< m_a < 0: described after half a turn about e₂
  Wide<T> A, B, M;      ///< amplitudes of m_a, m_b, m₂
  Wide<T> sn, cn, dn;   ///< at the start
  Wide<T> k2, mc;       ///< k², 1 − k²
  Wide<T> lambda;       ///< [1/s] of u
  Wide<T> half_period;  ///< of u: 2K
  Wide<T> rate;         ///< [rad/s] of ψ, and beside it per half period:
  Wide<T> angle_per_half_period;
  bool other_rate;  ///< which of the two characteristics: n (rate G/I_b) or N (rate G/I_a)
  Wide<T> nu, C, r, w;
};

/// Free rotation of a body with three different moments, off its principal axes and off the
/// separatrix. The unit vector m along L_P circles the axis e_a of the least moment where D2 < 0,
/// of the greatest where D2 > 0; e_b is the other of the two. With u = u₀ + λt:
///   m_a = ±A dn u,  m₂ = M sn u,  m_b = ±B cn u,
/// and the attitude is q₀ P₀⁻¹ exp(ψ e_a) P_t, where P_t turns m(t) onto e_a the shortest way.
/// The angle ψ in the form that does not cancel: doc/derivations/free_rotation.md.
template <class T>
class AsymmetricRotation {
 public:
  AsymmetricRotation(const AsymmetricPath<T>& path, const FreeInvariants<T>& invariants,
                     const Quaternion<T>& q_WP);

  /// All that it calls is inlined: it is most of what a state of a free body costs, and what the
  /// compiler would inline depends on the files that it is compiled with.
  __attribute__((flatten)) RotationState<T> at(T dt) const;

 private:
  /// The part of ψ/σ that is not proportional to time, from the argument u₀ to u = u₀ + v.
  T oscillation(const JacobiValues<T>& v, const JacobiValues<T>& u) const;

  Quaternion<T> before_;  ///< q₀ P₀⁻¹
  Wide<T> lambda_, half_period_;
  Wide<T> rate_, angle_per_half_period_;  ///< of ψ
  T magnitude_;                           ///< [kg m²/s] of L
  T sigma_;                               ///< +1 about e₁, −1 about e₃
  T amplitude_a_, amplitude_2_, amplitude_b_;
  JacobiValues<T> start_;
  JacobiFunctions<T> jacobi_;
  T k2_, nu_, C_, r_, w_;
  int a_;
  bool turned_, other_rate_;
};

/// Free rotation exactly on the separatrix, D2 = 0: m goes once over from −e₂ to e₂,
///   m = (A₁ sech u, tanh u, A₃ sech u),  u = u₀ + λt.
template <class T>
class SeparatrixRotation {
 public:
  SeparatrixRotation(const ScaledInertia<T>& inertia, const FreeInvariants<T>& invariants,
                     const Quaternion<T>& q_WP);

  RotationState<T> at(T dt) const;

 private:
  Vector3<T> momentum(T u) const;
  T angle(T u) const;

  int a_;                 ///< index of the axis that P turns m onto, the one further from m
  bool turned_;           ///< m_a < 0: described after half a turn about e₂
  T other_sign_;          ///< of the third component of m, then
  T sigma_;               ///< sign of the oscillation of ψ
  Quaternion<T> before_;  ///< q₀ P₀⁻¹
  T magnitude_;           ///< [kg m²/s] of L
  T amplitude_1_, amplitude_3_;
  Wide<T> lambda_, rate_;
  T u0_;
};

extern template struct AsymmetricPath<double>;
extern template struct AsymmetricPath<long double>;
extern template class AsymmetricRotation<double>;
extern template class AsymmetricRotation<long double>;
extern template class SeparatrixRotation<double>;
extern template class SeparatrixRotation<long double>;

}  // namespace rigid_body_sim
