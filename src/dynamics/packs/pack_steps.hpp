#pragma once

#include "dynamics/packs/pack.hpp"
#include "dynamics/packs/pack_block.hpp"
#include "dynamics/rotation/free_motion.hpp"

/// Steps of the integrators for bodies without torque, T: double or a pack. The drifts are those of
/// free_motion.hpp, which the methods themselves take. Only the order of kicks and drifts, and the
/// stages of rk4, stand here and there: the methods have many bodies, laws and wrenches, and this
/// nothing but numbers.
namespace rigid_body_sim {

/// The bodies of a block from one lane on.
template <class T>
class PackLanes {
 public:
  RIGID_BODY_SIM_INLINE PackLanes(PackBlock& block, std::size_t lane)
      : block_(block), lane_(lane) {}

  RIGID_BODY_SIM_INLINE T at(int column) const {
    T value;
    load(block_.columns[column] + lane_, value);
    return value;
  }
  RIGID_BODY_SIM_INLINE Triple<T> tripleAt(int column) const {
    return {at(column), at(column + 1), at(column + 2)};
  }
  RIGID_BODY_SIM_INLINE Quad<T> quadAt(int column) const {
    return {at(column), at(column + 1), at(column + 2), at(column + 3)};
  }

  RIGID_BODY_SIM_INLINE void put(int column, const T& value) {
    store(value, block_.columns[column] + lane_);
  }
  RIGID_BODY_SIM_INLINE void put(int column, const Triple<T>& v) {
    put(column, v.x);
    put(column + 1, v.y);
    put(column + 2, v.z);
  }
  RIGID_BODY_SIM_INLINE void put(int column, const Quad<T>& q) {
    put(column, Triple<T>{q.x, q.y, q.z});
    put(column + 3, q.w);
  }

 private:
  PackBlock& block_;
  std::size_t lane_;
};

template <class T>
RIGID_BODY_SIM_INLINE Triple<T> plusZero(const Triple<T>& v) {
  return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}

/// x += d, compensated.
template <class T>
RIGID_BODY_SIM_INLINE void moveLanes(const Triple<T>& d, PackLanes<T>& lanes) {
  Triple<T> x = lanes.tripleAt(kPositionColumn), low = lanes.tripleAt(kPositionLowColumn);
  moveBy(d.x, x.x, low.x);
  moveBy(d.y, x.y, low.y);
  moveBy(d.z, x.z, low.z);
  lanes.put(kPositionColumn, x);
  lanes.put(kPositionLowColumn, low);
}

struct SemiImplicitEulerPack {
  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes) {
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

template <int a, int b>
struct StrangPack {
  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes) {
    kickMoveKick(h, lanes);
    Triple<T> L_P = plusZero(lanes.tripleAt(kSpinColumn));
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    const T half_a = 0.5 * h * lanes.at(kRotationColumn);
    turnPackAboutAxis<a>(half_a, q, L_P);
    turnPackAboutAxis<b>(T(h * lanes.at(kRotationColumn + 1)), q, L_P);
    turnPackAboutAxis<a>(half_a, q, L_P);
    const T in_world = h * lanes.at(kRotationColumn + 2);
    turnInWorld(in_world * lanes.tripleAt(kWorldSpinColumn), q);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, plusZero(L_P));
  }
};

struct Magnus4Pack {
  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes) {
    kickMoveKick(h, lanes);
    Triple<T> L_P = plusZero(lanes.tripleAt(kSpinColumn));
    Quad<T> q = lanes.quadAt(kAttitudeColumn);
    driftMagnus(lanes.tripleAt(kRotationColumn), h, q, L_P);
    lanes.put(kAttitudeColumn, q);
    lanes.put(kSpinColumn, plusZero(L_P));
  }
};

/// Stages and weights as in rk4.cpp.
struct Rk4Pack {
  template <class T>
  static RIGID_BODY_SIM_INLINE void step(double h, PackLanes<T>& lanes) {
    constexpr double kNode[4]{0, 0.5, 0.5, 1}, kWeight[4]{1. / 6, 1. / 3, 1. / 3, 1. / 6};
    const Triple<T> f = lanes.tripleAt(kForceColumn), p = lanes.tripleAt(kMomentumColumn);
    const Triple<T> L_P = lanes.tripleAt(kSpinColumn);
    const Quad<T> q = lanes.quadAt(kAttitudeColumn);
    Rate<T> rate = rateAt(lanes, p, q, L_P), sum{};
    sum.add(kWeight[0], rate);
    Triple<T> force = plusZero(kWeight[0] * f);
    for (int stage = 1; stage < 4; ++stage) {
      const double step = kNode[stage] * h;
      rate = rateAt(lanes, p + step * f, sumOf(q, step, rate.q), L_P + step * rate.L_P);
      sum.add(kWeight[stage], rate);
      force = force + kWeight[stage] * f;
    }
    moveLanes(h * sum.x, lanes);
    lanes.put(kMomentumColumn, p + h * force);
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
    Triple<T> x;
    Quad<T> q;
    Triple<T> L_P;

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

  template <class T>
  static RIGID_BODY_SIM_INLINE Rate<T> rateAt(const PackLanes<T>& lanes, const Triple<T>& p,
                                              const Quad<T>& q, const Triple<T>& L_P) {
    const Triple<T> w = scaled(lanes.tripleAt(kRotationColumn), L_P);
    const T mass = lanes.at(kMassColumn);
    Rate<T> rate;
    rate.x = {p.x / mass, p.y / mass, p.z / mass};
    rate.q = product(q, Quad<T>{0.5 * w.x, 0.5 * w.y, 0.5 * w.z, T(0.0)});
    rate.L_P = plusZero(gyroscopicTorque(lanes.tripleAt(kDifferencesColumn), w));
    return rate;
  }
};

}  // namespace rigid_body_sim
