#pragma once

#include <algorithm>

#include "dynamics/taylor/taylor_drive.hpp"
#include "dynamics/taylor/taylor_products.hpp"

/// What a TaylorDrive adds to the recursion. Included by taylor_recursion.cpp alone.
namespace rigid_body_sim {

template <class T>
class DriveRecursion {
 public:
  RIGID_BODY_SIM_INLINE explicit DriveRecursion(TaylorDrive<T>& drive) : drive_(drive) {
    load<T>(drive.inv_I, inv_I_);
    set<T>(0, 0, 0, 0, force_W_);
    for (std::size_t i = 0; i < drive.momentum_terms; ++i) {
      Lanes<T> momentum;
      load<T>(drive.momentum[i], momentum);
      permute<1, 2, 0, 3, T>(momentum, momentum_yzx_[i]);
      permute<2, 0, 1, 3, T>(momentum, momentum_zxy_[i]);
    }
  }

  /// To the coefficient k of ω', from those of ω up to k.
  RIGID_BODY_SIM_INLINE void addAcceleration(const ArrangedSeries<T>& a, std::size_t k,
                                             Lanes<T>& w_dot) const {
    Lanes<T> acceleration, precession;
    load<T>(drive_.acceleration[k], acceleration);
    set<T>(0, 0, 0, 0, precession);
    for (std::size_t i = 0; i < std::min(k + 1, drive_.momentum_terms); ++i)
      precession += momentum_yzx_[i] * a[k - i].right[0] - momentum_zxy_[i] * a[k - i].left[0];
    w_dot += acceleration + inv_I_ * precession;
  }

  /// The coefficients k of R f and R τ, from the products of q up to k.
  RIGID_BODY_SIM_INLINE void turn(std::size_t k, const Products<T>& p, T inverse) {
    T sq[4], cr[4], tu[4];
    store<T>(p.squares, sq);
    store<T>(p.crosses, cr);
    store<T>(p.turns, tu);
    const T one = k == 0 ? T(1) : T(0), two = T(2);
    set<T>(one - two * (sq[1] + sq[2]), two * (cr[0] + tu[2]), two * (cr[2] - tu[1]), 0, R_x_[k]);
    set<T>(two * (cr[0] - tu[2]), one - two * (sq[0] + sq[2]), two * (cr[1] + tu[0]), 0, R_y_[k]);
    set<T>(two * (cr[2] + tu[1]), two * (cr[1] - tu[0]), one - two * (sq[0] + sq[1]), 0, R_z_[k]);
    turned(drive_.force, drive_.force_terms, k, force_W_);
    store<T>(force_W_ * inverse, drive_.impulse[k + 1]);
    Lanes<T> torque_W;
    turned(drive_.torque, drive_.torque_terms, k, torque_W);
    store<T>(torque_W * inverse, drive_.twist[k + 1]);
  }

  /// The coefficient of R f/m that turn() found last.
  Vector3<T> pushed() const {
    return Vector3<T>(force_W_[0], force_W_[1], force_W_[2]) * drive_.inv_mass;
  }

 private:
  RIGID_BODY_SIM_INLINE void turned(const typename TaylorDrive<T>::Coefficients& v_P,
                                    std::size_t terms, std::size_t k, Lanes<T>& v_W) const {
    set<T>(0, 0, 0, 0, v_W);
    for (std::size_t i = 0; i < std::min(k + 1, terms); ++i)
      v_W += (R_x_[k - i] * v_P[i][0] + R_y_[k - i] * v_P[i][1]) + R_z_[k - i] * v_P[i][2];
  }

  static constexpr std::size_t kSize = kHighestTaylorDegree + 1;
  TaylorDrive<T>& drive_;
  Lanes<T> inv_I_, force_W_;
  Lanes<T> momentum_yzx_[kSize], momentum_zxy_[kSize];
  Lanes<T> R_x_[kSize], R_y_[kSize], R_z_[kSize];
};

}  // namespace rigid_body_sim
