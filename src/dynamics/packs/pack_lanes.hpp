#pragma once

#include <type_traits>
#include <utility>

#include "dynamics/laws/drag_flow.hpp"
#include "dynamics/packs/pack_block.hpp"
#include "dynamics/rotation/free_motion.hpp"
#include "math/pack.hpp"

/// What steps of packs are made of: the numbers of some bodies, what acts on them, kicks and ways.
namespace rigid_body_sim {

/// Numbers of a block from one lane on.
template <class T, class Block>
class BlockLanes {
 public:
  RIGID_BODY_SIM_INLINE BlockLanes(Block& block, std::size_t lane)
      : first_(&block.columns[0][lane]) {}

  RIGID_BODY_SIM_INLINE T at(int column) const {
    T value;
    load(place(column), value);
    return value;
  }
  RIGID_BODY_SIM_INLINE Triple<T> tripleAt(int column) const {
    return {at(column), at(column + 1), at(column + 2)};
  }

 protected:
  using Number = std::remove_reference_t<decltype(std::declval<Block&>().columns[0][0])>;

  /// All at a constant distance from the first, whatever the lane.
  RIGID_BODY_SIM_INLINE Number* place(int column) const {
    return first_ + column * static_cast<int>(PackBlock::kLanes);
  }

 private:
  Number* first_;
};

/// The bodies of a block from one lane on.
template <class T>
class PackLanes : public BlockLanes<T, PackBlock> {
  using Base = BlockLanes<T, PackBlock>;
  using Base::place;

 public:
  using Base::at;
  using Base::Base;

  RIGID_BODY_SIM_INLINE Quad<T> quadAt(int column) const {
    return {at(column), at(column + 1), at(column + 2), at(column + 3)};
  }

  RIGID_BODY_SIM_INLINE void put(int column, const T& value) { store(value, place(column)); }
  RIGID_BODY_SIM_INLINE void put(int column, const Triple<T>& v) {
    put(column, v.x);
    put(column + 1, v.y);
    put(column + 2, v.z);
  }
  RIGID_BODY_SIM_INLINE void put(int column, const Quad<T>& q) {
    put(column, Triple<T>{q.x, q.y, q.z});
    put(column + 3, q.w);
  }
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

/// No torque, and no force in body axes.
struct NoPush {
  static constexpr bool kActs = false;
};

/// A wrench, as Wrench.
template <class T>
struct PackWrench {
  Triple<T> f_W, tau_W, tau_P;
};

/// What is held on the bodies of a block from one lane on, one force at a point of the body at
/// most.
template <class T>
class PushLanes : public BlockLanes<T, const PushBlock> {
  using Base = BlockLanes<T, const PushBlock>;

 public:
  static constexpr bool kActs = true;

  using Base::Base;
  using Base::tripleAt;

  /// As HeldWrench::at, and gravity.
  RIGID_BODY_SIM_INLINE PackWrench<T> held(const Triple<T>& f_W, const Quad<T>& q) const {
    return {(f_W + rotate(q, tripleAt(kBodyForceColumn))) + tripleAt(kWeightColumn),
            tripleAt(kCoupleColumn),
            tripleAt(kBodyCoupleColumn) +
                cross(tripleAt(kArmColumn), rotateBack(q, tripleAt(kArmForceColumn)))};
  }

  /// All that acts, at the velocity v_W and the angular velocity w_P.
  RIGID_BODY_SIM_INLINE PackWrench<T> all(const Triple<T>& f_W, const Quad<T>& q,
                                          const Triple<T>& /*v_W*/,
                                          const Triple<T>& /*w_P*/) const {
    return held(f_W, q);
  }

  /// As `kick` of free_motion.hpp; returns L_P.
  RIGID_BODY_SIM_INLINE Triple<T> kick(double h, const Quad<T>& q, const Triple<T>& L_P,
                                       PackLanes<T>& lanes) const {
    const PackWrench<T> wrench = held(lanes.tripleAt(kForceColumn), q);
    lanes.put(kMomentumColumn, lanes.tripleAt(kMomentumColumn) + h * wrench.f_W);
    lanes.put(kWorldSpinColumn,
              lanes.tripleAt(kWorldSpinColumn) + h * (wrench.tau_W + rotate(q, wrench.tau_P)));
    return L_P + h * (rotateBack(q, wrench.tau_W) + wrench.tau_P);
  }
};

/// The same with drag.
template <class T>
class DragLanes : public PushLanes<T> {
 public:
  using PushLanes<T>::PushLanes;

  /// As Drag::addWrenches.
  RIGID_BODY_SIM_INLINE PackWrench<T> all(const Triple<T>& f_W, const Quad<T>& q,
                                          const Triple<T>& v_W, const Triple<T>& w_P) const {
    const PackWrench<T> held = this->held(f_W, q);
    const T drag = this->at(kLinearDragColumn) + this->at(kQuadraticDragColumn) * speedOf(v_W);
    return {held.f_W - drag * v_W, held.tau_W, held.tau_P - this->at(kAngularDragColumn) * w_P};
  }

  /// As Drag::kick; returns L_P.
  RIGID_BODY_SIM_INLINE Triple<T> kick(double h, const Quad<T>& q, const Triple<T>& L_P,
                                       PackLanes<T>& lanes) const {
    const PackWrench<T> wrench = this->held(lanes.tripleAt(kForceColumn), q);
    const DragNumbers<T> drag{this->at(kLinearDragColumn), this->at(kQuadraticDragColumn),
                              this->at(kAngularDragColumn)};
    lanes.put(kMomentumColumn, relaxedMomentum(drag, lanes.at(kMassColumn),
                                               lanes.tripleAt(kMomentumColumn), wrench.f_W, h));
    const Triple<T> tau_P = wrench.tau_P + rotateBack(q, wrench.tau_W);
    const Triple<T> rate = this->tripleAt(kSpinDecayColumn);
    Triple<T> share{T(1.0), T(1.0), T(1.0)};
    if (anyNonZero(drag.angular))
      share = {smallDecayShare(T(rate.x * h)), smallDecayShare(T(rate.y * h)),
               smallDecayShare(T(rate.z * h))};
    const Triple<T> gain_P{relaxedGain(share.x, tau_P.x, rate.x, L_P.x, h),
                           relaxedGain(share.y, tau_P.y, rate.y, L_P.y, h),
                           relaxedGain(share.z, tau_P.z, rate.z, L_P.z, h)};
    lanes.put(kWorldSpinColumn, lanes.tripleAt(kWorldSpinColumn) + rotate(q, gain_P));
    return L_P + gain_P;
  }
};

/// x += h p/m
template <class T>
RIGID_BODY_SIM_INLINE void driftLanes(double h, PackLanes<T>& lanes) {
  moveLanes(T(h / lanes.at(kMassColumn)) * lanes.tripleAt(kMomentumColumn), lanes);
}

}  // namespace rigid_body_sim
