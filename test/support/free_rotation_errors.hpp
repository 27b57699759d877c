#pragma once

#include <algorithm>
#include <limits>

#include "dynamics/rotation/free_top.hpp"
#include "support/body_families.hpp"
#include "support/reference_free_rotation.hpp"

namespace rigid_body_sim {

inline FreeRotation<double> freeRotation(const SpinningBody& body) {
  return FreeTop<double>(body.I).from(body.q_WP, body.L_P, body.L_W());
}

/// The reference at t. Its L_P has the magnitude of L_W: to a unit of rounding the two accounts of
/// the angular momentum are two motions, and the free top's is this one.
template <class R = long double>
ReferenceFreeRotation<R> referenceAt(const SpinningBody& body, double t) {
  const Vector3<long double> L_P = body.L_P.cast<long double>();
  const long double magnitude = body.L_W().cast<long double>().stableNorm();
  ReferenceFreeRotation<R> reference(body.I, body.q_WP, L_P.stableNormalized() * magnitude);
  reference.advance(R(t));
  return reference;
}

/// [rad] The greater of the motions for many evaluations and for one.
inline double attitudeError(const SpinningBody& body, double t) {
  const auto reference = referenceAt(body, t);
  const Quaterniond once = FreeTop<double>(body.I).after(t, body.q_WP, body.L_P, body.L_W()).q_WP;
  return std::max(angleToReference(freeRotation(body).at(t).q_WP, reference.state()),
                  angleToReference(once, reference.state()));
}

/// How many times the attitude at t moves further than a component of L_P or I that is changed by
/// one unit of rounding; at least 1.
inline double condition(const SpinningBody& body, double t) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const ReferenceFreeRotation<long double> reference = referenceAt(body, t);
  double worst = 1;
  for (int i = 0; i < 6; ++i) {
    SpinningBody changed = body;
    double& component = i < 3 ? changed.L_P(i) : changed.I(i - 3);
    component *= 1 + kEps;
    const auto q = referenceAt(changed, t).state().q;
    const Quaterniond moved = Quaternion<long double>(q[0], q[1], q[2], q[3]).cast<double>();
    worst = std::max(worst, angleToReference(moved, reference.state()) / kEps);
  }
  return worst;
}

}  // namespace rigid_body_sim
