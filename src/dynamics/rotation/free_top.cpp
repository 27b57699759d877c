#include "dynamics/rotation/free_top.hpp"

namespace rigid_body_sim {
namespace {

template <class T>
InertiaKind inertiaKind(const Vector3<T>& I) {
  if (!(I(0) < I(2))) return InertiaKind::spherical;
  return I(0) < I(1) && I(1) < I(2) ? InertiaKind::asymmetric : InertiaKind::symmetric;
}

/// L along a principal axis, or none at all.
template <class T>
bool onPrincipalAxis(const Vector3<T>& L_P) {
  int zeros = 0;
  for (int i = 0; i < 3; ++i) zeros += L_P(i) == T(0) ? 1 : 0;
  return zeros >= 2;
}

/// ω = L/I about L, where L keeps to directions of the same moment I.
template <class T>
SteadyRotation<T> steadyRotation(const ScaledInertia<T>& inertia, const Quaternion<T>& q_WP,
                                 const Vector3<T>& L_P, const AngularMomentum<T>& L) {
  const Vector3<Wide<T>> moments(inertia.I1, inertia.I2, inertia.I3);
  const Wide<T> I = L.direction_P.cwiseAbs().maxCoeff() > Wide<T>(0)
                        ? L.direction_P.cwiseAbs2().dot(moments)
                        : inertia.I3;
  return {q_WP, L_P, Vector3<T>(L.direction_P.template cast<T>()), L.magnitude / inertia.unit / I};
}

template <class T>
Wide<T> norm(const Vector3<T>& v) {
  using std::sqrt;
  const T unit = v.cwiseAbs().maxCoeff();
  if (!(unit > T(0))) return Wide<T>(0);
  return Wide<T>(unit) * sqrt((v.template cast<Wide<T>>() / Wide<T>(unit)).squaredNorm());
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
AngularMomentum<T>::AngularMomentum(const Vector3<T>& L_P, const Vector3<T>& L_W)
    : magnitude(norm(L_W)), direction_P(L_P.template cast<Wide<T>>()) {
  const Wide<T> norm_P = norm(L_P);
  if (norm_P > Wide<T>(0)) direction_P /= norm_P;
}

template <class T>
FreeTop<T>::FreeTop(const Vector3<T>& I) : kind_(inertiaKind(I)), inertia_(I) {}

/// use: of a motion of most kinds; usePath(path, invariants): of three different moments in
/// general.
template <class T>
template <class Use, class UsePath>
auto FreeTop<T>::solve(const Quaternion<T>& q_WP, const Vector3<T>& L_P, const Vector3<T>& L_W,
                       const Use& use, const UsePath& usePath) const {
  const AngularMomentum<T> L(L_P, L_W);
  if (kind_ == InertiaKind::spherical || onPrincipalAxis(L_P))
    return use(steadyRotation(inertia_, q_WP, L_P, L));
  if (kind_ == InertiaKind::symmetric) return use(SymmetricRotation<T>(inertia_, q_WP, L));
  const FreeInvariants<T> invariants(inertia_, L);
  if (invariants.D2 == Wide<T>(0)) return use(SeparatrixRotation<T>(inertia_, invariants, q_WP));
  return usePath(AsymmetricPath<T>(inertia_, invariants), invariants);
}

template <class T>
FreeRotation<T> FreeTop<T>::from(const Quaternion<T>& q_WP, const Vector3<T>& L_P,
                                 const Vector3<T>& L_W, bool read_once) const {
  const auto use = [](const auto& motion) { return FreeRotation<T>(motion); };
  const auto usePath = [&](const AsymmetricPath<T>& path, const FreeInvariants<T>& invariants) {
    if constexpr (std::is_same_v<T, double>)
      if (const auto theta = read_once ? std::nullopt : ThetaRotation::of(path, invariants, q_WP))
        return FreeRotation<T>(*theta);
    return FreeRotation<T>(Boxed<AsymmetricRotation<T>>(std::in_place, path, invariants, q_WP));
  };
  return solve(q_WP, L_P, L_W, use, usePath);
}

template <class T>
RotationState<T> FreeTop<T>::after(T dt, const Quaternion<T>& q_WP, const Vector3<T>& L_P,
                                   const Vector3<T>& L_W) const {
  const auto use = [dt](const auto& motion) { return motion.at(dt); };
  const auto usePath = [&](const AsymmetricPath<T>& path, const FreeInvariants<T>& invariants) {
    return AsymmetricRotation<T>(path, invariants, q_WP).at(dt);
  };
  return solve(q_WP, L_P, L_W, use, usePath);
}

template struct ScaledInertia<double>;
template struct ScaledInertia<long double>;
template struct AngularMomentum<double>;
template struct AngularMomentum<long double>;
template class FreeTop<double>;
template class FreeTop<long double>;

}  // namespace rigid_body_sim
