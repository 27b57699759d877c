#pragma once

#include <array>
#include <optional>

#include "dynamics/rotation/asymmetric_rotation.hpp"

namespace rigid_body_sim {

/// Where the numbers of a ThetaRotation stand.
enum ThetaNumber : int {
  kArgumentRate = 0,    ///< [turns/s] of z, in three parts
  kArgumentStart = 3,   ///< [turns] z at dt = 0
  kPhaseRate = 4,       ///< [turns/s] of φ, in three parts
  kNome = 7,            ///< of the modulus
  kEvenReal = 8,        ///< of α, beside cos 2z, cos 4z, …; four
  kEvenImaginary = 12,  ///< of α, beside sin 2z, sin 4z, …; four
  kOddCosines = 16,     ///< of β, beside cos z, cos 3z, …; four
  kOddSines = 20,       ///< of β, beside sin z, sin 3z, …; four
  kAmplitudes = 24,     ///< [kg m²/s] of L_P along e_a, e₂ and e_b
  kBefore = 27,         ///< constant left factor: x, y, z, w
  kThetaNumbers = 31
};

/// The motion of AsymmetricRotation by theta functions: sums of sines and cosines of multiples of z
/// whose coefficients shrink like the squares of the multiples in the exponent of the nome. With
/// z = π u/2K, λ dt = u − u₀ and the unit vector m circling e_a, the attitude as a pair of complex
/// numbers (w + i e_a, the two others) is
///   q = before (α, β)/|(α, β)|,  α = e^{iφ} ϑ₄(z ± iη | q²),  β ∝ e^{iφ} ϑ₁(z ± iη | q²),
/// with |α|² + |β|² ∝ ϑ₄(z | q) and φ proportional to time, and
///   m_a ∝ ϑ₃/ϑ₄,  m₂ ∝ ϑ₁/ϑ₄,  m_b ∝ ϑ₂/ϑ₄  of (z | q).
/// It takes a fixed number of operations and no function of the C library, so that packs take it
/// (theta_motion.hpp), with the same bits. Derivation: doc/derivations/free_rotation.md.
class ThetaRotation {
 public:
  /// None where so few terms do not reach rounding, near the separatrix, or numbers are extreme.
  static std::optional<ThetaRotation> of(const AsymmetricPath<double>& path,
                                         const FreeInvariants<double>& invariants,
                                         const Quaterniond& q_WP);

  RotationState<double> at(double dt) const;

  /// Index of the axis circled, 0 or 2.
  int axis() const { return a_; }
  const double* numbers() const { return numbers_.data(); }

 private:
  ThetaRotation() = default;
  void setRate(std::size_t first, Wide<double> rate);
  void setSeries(const AsymmetricPath<double>& path, Wide<double> nome, Wide<double> K);
  void setAmplitudes(const AsymmetricPath<double>& path, Wide<double> nome, double magnitude);
  void setBefore(const Quaterniond& q_WP);

  std::array<double, kThetaNumbers> numbers_{};
  int a_ = 0;
};

}  // namespace rigid_body_sim
