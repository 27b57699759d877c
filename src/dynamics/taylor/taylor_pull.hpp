#pragma once

#include <array>

#include "dynamics/taylor/lanes.hpp"
#include "dynamics/taylor/taylor_equations.hpp"
#include "dynamics/taylor/taylor_terms.hpp"

namespace rigid_body_sim {

/// The torque of a TaylorPull in principal axes, degree by degree.
template <class T>
class PullRecursion {
 public:
  explicit PullRecursion(const TaylorPull<T>& pull) : pull_(pull) {
    for (auto& torque : torque_W_) torque.setZero();
    torque_W_[1] = vector(pull.linear_W);
    torque_W_[2] = vector(pull.quadratic_W);
  }

  /// The coefficient k of I⁻¹ × the torque in P, from those of the products of q up to k.
  Vector3<T> accelerationOf(std::size_t k, const Lanes<T>& squares, const Lanes<T>& crosses,
                            const Lanes<T>& turns) {
    Matrix3<T>& R = R_[k];
    // as plain numbers: a template deduced from the lanes would take them for aligned to 32 bytes
    T squares_k[4], crosses_k[4], turns_k[4];
    store<T>(squares, squares_k);
    store<T>(crosses, crosses_k);
    store<T>(turns, turns_k);
    setRotationMatrix<T>(k == 0 ? T(1) : T(0), squares_k, crosses_k, turns_k, R);
    if (k + 2 < torque_W_.size())
      torque_W_[k + 2] += vector(pull_.force_W).cross(R * vector(pull_.acceleration_P)) *
                          (kInverse<T>[k + 1] * kInverse<T>[k + 2]);
    Vector3<T> torque_P = Vector3<T>::Zero();
    for (std::size_t i = 1; i <= k; ++i) torque_P += R_[k - i].transpose() * torque_W_[i];
    return torque_P.cwiseProduct(vector(pull_.inv_I));
  }

  /// What the coefficient k of another acceleration of the body [m/s²] adds, by time in the unit of
  /// the series.
  void accelerate(std::size_t k, const Vector3<T>& acceleration_W) {
    if (k + 2 < torque_W_.size())
      torque_W_[k + 2] +=
          vector(pull_.force_W).cross(acceleration_W) * (kInverse<T>[k + 1] * kInverse<T>[k + 2]);
  }

  /// The coefficient k + 1 of the integral of the torque in world axes.
  void integral(std::size_t k, T (&to)[4]) const {
    for (int i = 0; i < 3; ++i) to[i] = torque_W_[k][i] * kInverse<T>[k + 1];
    to[3] = T(0);
  }

 private:
  static Vector3<T> vector(const T (&v)[3]) { return Vector3<T>(v[0], v[1], v[2]); }

  const TaylorPull<T>& pull_;
  std::array<Matrix3<T>, kHighestTaylorDegree> R_;
  std::array<Vector3<T>, kHighestTaylorDegree> torque_W_;
};

}  // namespace rigid_body_sim
