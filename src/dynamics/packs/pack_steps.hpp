#pragma once

#include "dynamics/packs/pack_lanes.hpp"

/// Steps of the integrators for bodies by themselves, T: double or a pack. The drifts are those of
/// free_motion.hpp, which the methods themselves take. Only the order of kicks and drifts, and the
/// stages of rk4, stand here and there: the methods have many bodies, laws and wrenches, and this
/// nothing but numbers. Push: NoPush, PushLanes or DragLanes.
namespace rigid_body_sim {

struct SemiImplicitEulerPack {
  template <class T, class Push>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes, const Push& push) {
    const Triple<T> inv_I = lanes.tripleAt(kRotationColumn);
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    Triple<T> L_P = lanes.tripleAt(kSpinColumn);
    magnify(h, inv_I, L_P, lanes);
    L_P = push.kick(h, q, L_P, lanes);
    driftLanes(h, lanes);
    driftAlongOmega(inv_I, h, lanes.tripleAt(kWorldSpinColumn), q, L_P);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, L_P);
  }

  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes, NoPush /*none*/) {
    const Triple<T> p = lanes.tripleAt(kMomentumColumn) + h * lanes.tripleAt(kForceColumn);
    lanes.put(kMomentumColumn, p);
    moveLanes(T(h / lanes.at(kMassColumn)) * p, lanes);
    const Triple<T> inv_I = lanes.tripleAt(kRotationColumn);
    Triple<T> L_P = plusZero(lanes.tripleAt(kSpinColumn));
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    magnify(h, inv_I, L_P, lanes);
    driftAlongOmega(inv_I, h, lanes.tripleAt(kWorldSpinColumn), q, L_P);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, L_P);
  }

 private:
  /// As Stepper::divide.
  template <class T>
  static RIGID_BODY_SIM_INLINE void magnify(double h, const Triple<T>& inv_I, const Triple<T>& L_P,
                                            PackLanes<T>& lanes) {
    const T growth = positivePart(leastAxisExcess(inv_I, L_P));
    lanes.put(kMagnificationColumn, T(lanes.at(kMagnificationColumn) + h * h * (0.5 * growth)));
  }
};

/// The kicks of a step of strang or magnus4, whose impulses are the same, and its way.
template <class T>
RIGID_BODY_SIM_INLINE void kickMoveKick(double h, PackLanes<T>& lanes) {
  const Triple<T> push = 0.5 * h * lanes.tripleAt(kForceColumn);
  const Triple<T> p = lanes.tripleAt(kMomentumColumn) + push;
  moveLanes(T(h / lanes.at(kMassColumn)) * p, lanes);
  lanes.put(kMomentumColumn, p + push);
}

/// Component i modulo 3 of a triple, or of the vector part of a quad.
template <int i, class Components>
RIGID_BODY_SIM_INLINE auto& component(Components& v) {
  if constexpr (i % 3 == 0)
    return v.x;
  else if constexpr (i % 3 == 1)
    return v.y;
  else
    return v.z;
}

template <int i, class T>
RIGID_BODY_SIM_INLINE void turnPackAboutAxis(const T& hk, Quad<T>& q, Triple<T>& L_P) {
  turnAboutAxis(hk, component<i>(L_P), component<i + 1>(L_P), component<i + 2>(L_P),
                component<i>(q), component<i + 1>(q), component<i + 2>(q), q.w);
}

/// kick h/2, drift h, kick h/2
template <class Drift>
struct KickDriftKickPack {
  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes, NoPush /*none*/) {
    kickMoveKick(h, lanes);
    Triple<T> L_P = plusZero(lanes.tripleAt(kSpinColumn));
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    Drift::turn(h, lanes, q, L_P);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, plusZero(L_P));
  }

  template <class T, class Push>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes, const Push& push) {
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    Triple<T> L_P = push.kick(0.5 * h, q, lanes.tripleAt(kSpinColumn), lanes);
    driftLanes(h, lanes);
    Drift::turn(h, lanes, q, L_P);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, push.kick(0.5 * h, q, L_P, lanes));
  }
};

template <int a, int b>
struct StrangDrift {
  template <class T>
  static RIGID_BODY_SIM_INLINE void turn(double h, const PackLanes<T>& lanes, Quad<T>& q,
                                         Triple<T>& L_P) {
    const T half_a = 0.5 * h * lanes.at(kRotationColumn);
    turnPackAboutAxis<a>(half_a, q, L_P);
    turnPackAboutAxis<b>(T(h * lanes.at(kRotationColumn + 1)), q, L_P);
    turnPackAboutAxis<a>(half_a, q, L_P);
    const T in_world = h * lanes.at(kRotationColumn + 2);
    turnInWorld(in_world * lanes.tripleAt(kWorldSpinColumn), q);
  }
};

struct Magnus4Drift {
  template <class T>
  static RIGID_BODY_SIM_INLINE void turn(double h, const PackLanes<T>& lanes, Quad<T>& q,
                                         Triple<T>& L_P) {
    driftMagnus(lanes.tripleAt(kRotationColumn), h, q, L_P);
  }
};

template <int a, int b>
using StrangPack = KickDriftKickPack<StrangDrift<a, b>>;
using Magnus4Pack = KickDriftKickPack<Magnus4Drift>;

/// Stages and weights as in rk4.cpp.
struct Rk4Pack {
  template <class T, class Push>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes, const Push& push) {
    constexpr double kNode[4]{0, 0.5, 0.5, 1}, kWeight[4]{1. / 6, 1. / 3, 1. / 3, 1. / 6};
    const Triple<T> p = lanes.tripleAt(kMomentumColumn), L_P = lanes.tripleAt(kSpinColumn);
    const Quad<T> q = lanes.quadAt(kAttitudeColumn);
    Rate<T> rate = rateAt(lanes, push, p, q, L_P), sum{};
    sum.add(kWeight[0], rate);
    sum.p = plusZero(kWeight[0] * rate.p);
    for (int stage = 1; stage < 4; ++stage) {
      const double step = kNode[stage] * h;
      rate = rateAt(lanes, push, p + step * rate.p, sumOf(q, step, rate.q), L_P + step * rate.L_P);
      sum.add(kWeight[stage], rate);
      sum.p = sum.p + kWeight[stage] * rate.p;
    }
    moveLanes(h * sum.x, lanes);
    lanes.put(kMomentumColumn, p + h * sum.p);
    const Triple<T> L_end = L_P + h * sum.L_P;
    Quad<T> q_end = sumOf(q, h, sum.q);
    const T norm = squareRoot(squaredNorm(q_end));
    q_end = {q_end.x / norm, q_end.y / norm, q_end.z / norm, q_end.w / norm};
    lanes.put(kAttitudeColumn, q_end);
    lanes.put(kSpinColumn, L_end);
    lanes.put(kWorldSpinColumn, rotate(q_end, L_end));
  }

 private:
  template <class T>
  struct Rate {
    Triple<T> x, p;
    Quad<T> q;
    Triple<T> L_P;

    /// But for p.
    RIGID_BODY_SIM_INLINE void add(double weight, const Rate& rate) {
      x = x + weight * rate.x;
      q = sumOf(q, weight, rate.q);
      L_P = L_P + weight * rate.L_P;
    }
  };

  template <class T>
  static RIGID_BODY_SIM_INLINE Quad<T> sumOf(const Quad<T>& q, double weight, const Quad<T>& r) {
    return {q.x + weight * r.x, q.y + weight * r.y, q.z + weight * r.z, q.w + weight * r.w};
  }

  template <class T, class Push>
  static RIGID_BODY_SIM_INLINE Rate<T> rateAt(const PackLanes<T>& lanes, const Push& push,
                                              const Triple<T>& p, const Quad<T>& q,
                                              const Triple<T>& L_P) {
    const Triple<T> w = scaled(lanes.tripleAt(kRotationColumn), L_P);
    const T mass = lanes.at(kMassColumn);
    Rate<T> rate;
    rate.x = {p.x / mass, p.y / mass, p.z / mass};
    rate.p = lanes.tripleAt(kForceColumn);
    rate.q = product(q, Quad<T>{0.5 * w.x, 0.5 * w.y, 0.5 * w.z, T(0.0)});
    rate.L_P = gyroscopicTorque(lanes.tripleAt(kDifferencesColumn), w);
    if constexpr (Push::kActs) {
      const PackWrench<T> wrench = push.all(rate.p, q, rate.x, w);
      rate.p = wrench.f_W;
      rate.L_P = (rate.L_P + rotateBack(q, wrench.tau_W)) + wrench.tau_P;
    } else {
      rate.L_P = plusZero(rate.L_P);
    }
    return rate;
  }
};

}  // namespace rigid_body_sim
