#pragma once

#include <type_traits>
#include <variant>

#include "dynamics/rotation/asymmetric_rotation.hpp"
#include "dynamics/rotation/symmetric_rotation.hpp"
#include "dynamics/rotation/theta_rotation.hpp"
#include "math/boxed.hpp"

namespace rigid_body_sim {

/// How many principal moments of a body are equal, to the last bit.
enum class InertiaKind { spherical, symmetric, asymmetric };

template <class T>
struct RotationKinds {
  using Motion = std::variant<SteadyRotation<T>, SymmetricRotation<T>, SeparatrixRotation<T>,
                              Boxed<AsymmetricRotation<T>>>;
};
template <>
struct RotationKinds<double> {
  using Motion =
      std::variant<SteadyRotation<double>, SymmetricRotation<double>, SeparatrixRotation<double>,
                   Boxed<AsymmetricRotation<double>>, ThetaRotation>;
};

/// The free rotation of a body from one instant on: all that is constant along the motion, worked
/// out once; any later or earlier time is one evaluation, and nothing accumulates.
template <class T>
class FreeRotation {
 public:
  using Motion = typename RotationKinds<T>::Motion;
  explicit FreeRotation(Motion motion) : motion_(std::move(motion)) {}

  /// The rotation dt [s] after the anchor, of either sign and any size. The angular momentum in
  /// world axes is constant and not part of the answer.
  RotationState<T> at(T dt) const {
    return std::visit(
        [dt](const auto& motion) {
          if constexpr (std::is_same_v<decltype(motion), const Boxed<AsymmetricRotation<T>>&>)
            return motion->at(dt);
          else
            return motion.at(dt);
        },
        motion_);
  }

  /// Null where it is another kind of motion.
  const ThetaRotation* asTheta() const { return std::get_if<ThetaRotation>(&motion_); }

 private:
  Motion motion_;
};

/// The exact free rotation of a body, by the kind of its inertia: spherical, one rotation about L;
/// symmetric, two rotations; asymmetric, theta functions or, near the separatrix, elliptic ones.
/// Derivation and sources: doc/derivations/free_rotation.md.
///
/// Of the two accounts of the angular momentum, L_P gives the direction and L_W the magnitude (see
/// AngularMomentum). The axis of precession is R(q_WP) L_P, so that the motion starts exactly at
/// q_WP; where it differs from L_W it does so by rounding, and goes on differing by no more.
template <class T>
class FreeTop {
 public:
  /// Principal moments I [kg m²], ascending, all > 0.
  explicit FreeTop(const Vector3<T>& I);

  InertiaKind kind() const { return kind_; }

  /// The motion of the body that at dt = 0 has attitude q_WP (unit) and angular momentum
  /// [kg m²/s] L_P in principal axes, L_W = R(q_WP) L_P in world axes. read_once: as a motion the
  /// constants of which take little to find, but each time of it more.
  FreeRotation<T> from(const Quaternion<T>& q_WP, const Vector3<T>& L_P, const Vector3<T>& L_W,
                       bool read_once = false) const;

  /// The same at one time dt [s] after, to rounding: for one evaluation `from` does too much.
  RotationState<T> after(T dt, const Quaternion<T>& q_WP, const Vector3<T>& L_P,
                         const Vector3<T>& L_W) const;

 private:
  template <class Use, class UsePath>
  auto solve(const Quaternion<T>& q_WP, const Vector3<T>& L_P, const Vector3<T>& L_W,
             const Use& use, const UsePath& usePath) const;

  InertiaKind kind_;
  ScaledInertia<T> inertia_;
};

extern template class FreeTop<double>;
extern template class FreeTop<long double>;

}  // namespace rigid_body_sim
