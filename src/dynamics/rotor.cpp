#include <rigid_body_sim/dynamics/rotor.hpp>

namespace rigid_body_sim {
namespace {

template <class T>
InertiaKind inertiaKind(const Vector3<T>& I) {
  if (!(I(0) < I(2))) return InertiaKind::spherical;
  return I(0) < I(1) && I(1) < I(2) ? InertiaKind::asymmetric : InertiaKind::symmetric;
}

/// L_P along a principal axis, or none at all.
template <class T>
bool onPrincipalAxis(const Vector3<T>& L_P) {
  int zeros = 0;
  for (int i = 0; i < 3; ++i) zeros += L_P(i) == T(0) ? 1 : 0;
  return zeros >= 2;
}

/// ω = L/I about L, where the moment I is the same for every direction that L takes.
template <class T>
SteadyRotation<T> steadyRotation(const ScaledInertia<T>& inertia, const Quaternion<T>& q_WP,
                                 const Vector3<T>& L_P) {
  using std::sqrt;
  using W = Wide<T>;
  const T unit = L_P.cwiseAbs().maxCoeff();
  if (!(unit > T(0))) return {q_WP, L_P, Vector3<T>::Zero(), W(0)};
  const Vector3<W> m = L_P.template cast<W>() / W(unit);
  const W G = sqrt(m.squaredNorm());
  const W I = m.cwiseAbs2().dot(Vector3<W>(inertia.I1, inertia.I2, inertia.I3)) / (G * G);
  return {q_WP, L_P, Vector3<T>((m / G).template cast<T>()), W(unit) / inertia.unit * G / I};
}

}  // namespace

template <class T>
ScaledInertia<T>::ScaledInertia(const Vector3<T>& I)
    : unit(I(2)),
      I1(Wide<T>(I(0)) / unit),
      I2(Wide<T>(I(1)) / unit),
      I3(1),
      I21((Wide<T>(I(1)) - Wide<T>(I(0))) / unit),
      I31((Wide<T>(I(2)) - Wide<T>(I(0))) / unit),
      I32((Wide<T>(I(2)) - Wide<T>(I(1))) / unit) {}

template <class T>
Rotor<T>::Rotor(const Vector3<T>& I) : kind_(inertiaKind(I)), inertia_(I) {}

template <class T>
FreeRotation<T> Rotor<T>::from(const Quaternion<T>& q_WP, const Vector3<T>& L_P) const {
  if (kind_ == InertiaKind::spherical || onPrincipalAxis(L_P))
    return FreeRotation<T>(steadyRotation(inertia_, q_WP, L_P));
  if (kind_ == InertiaKind::symmetric)
    return FreeRotation<T>(SymmetricRotation<T>(inertia_, q_WP, L_P));
  const FreeInvariants<T> invariants(inertia_, L_P);
  if (invariants.D2 == Wide<T>(0))
    return FreeRotation<T>(SeparatrixRotation<T>(inertia_, invariants, q_WP));
  return FreeRotation<T>(AsymmetricRotation<T>(inertia_, invariants, q_WP));
}

template struct ScaledInertia<double>;
template struct ScaledInertia<long double>;
template class Rotor<double>;
template class Rotor<long double>;

}  // namespace rigid_body_sim
