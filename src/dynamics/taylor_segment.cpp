#include <algorithm>
#include <cmath>

#include <rigid_body_sim/dynamics/taylor_segment.hpp>

#include "taylor_terms.hpp"

namespace rigid_body_sim {

/// What stays constant over the segment, in the units of the scene.
template <class T>
struct TaylorSegmentT<T>::Equations {
  Array4 w_P;         ///< [rad/s] at the start
  Array4 gyroscopic;  ///< (I₂ − I₃)/I₁ and cyclic: ω₁' = gyroscopic₁ ω₂ ω₃ + …
  Array4 inv_I;       ///< [1/(kg m²)]
  Array4 alpha_P;     ///< [rad/s²] I⁻¹ tau_P
  Vector3<T> tau_P;   ///< [N m]
  Vector3<T> f_P;     ///< [N]
  Matrix3<T> moments;             ///< [N m] Σ armᵢ forceᵢᵀ, arms in P, forces in W
  Vector3<T> pull_W;              ///< [N] sum of the forces at world points
  Vector3<T> v_W;                 ///< [m/s] at the start
  std::array<Array4, 9> turning;  ///< [rad/s²] I⁻¹ × torque in P = Σ R(j, l) turning[3 j + l]
};

template <class T>
TaylorSegmentT<T>::TaylorSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                                  const BodyStateT<T>& start, T horizon)
    : start_(start),
      I_(body.I.template cast<T>()),
      inv_mass_(T(1) / T(body.mass)),
      f_W_((wrench.f_W).template cast<T>() + T(body.mass) * g_W.template cast<T>()),
      a_W_(wrench.f_W.template cast<T>() * inv_mass_ + g_W.template cast<T>()),
      tau_W_(wrench.tau_W.template cast<T>()),
      body_force_(!wrench.f_P.isZero(0)),
      body_torque_(!wrench.tau_P.isZero(0) || !wrench.levers.empty() || !wrench.pulls.empty()) {
  Equations e;
  e.w_P = lanes<T>(start.L_P.cwiseQuotient(I_));
  e.inv_I = lanes<T>(I_.cwiseInverse());
  e.gyroscopic =
      Array4((I_[1] - I_[2]) / I_[0], (I_[2] - I_[0]) / I_[1], (I_[0] - I_[1]) / I_[2], T(0));
  e.tau_P = wrench.tau_P.template cast<T>();
  e.f_P = wrench.f_P.template cast<T>();
  e.alpha_P = e.inv_I * lanes<T>(e.tau_P);
  e.moments.setZero();
  for (const HeldWrench::Lever& lever : wrench.levers)
    e.moments += lever.arm_P.template cast<T>() * lever.force_W.template cast<T>().transpose();
  e.pull_W.setZero();
  for (const HeldWrench::Pull& pull : wrench.pulls) {
    const Vector3<T> force_W = pull.force_W.template cast<T>();
    e.pull_W += force_W;
    tau_W_ += ((pull.point_W.template cast<T>() - start.x_W) - start.x_low_W).cross(force_W);
  }
  e.v_W = start.p_W * inv_mass_;

  e.turning.fill(Array4::Zero());
  T square = maxAbs(e.alpha_P);
  const bool turned = !tau_W_.isZero(0) || !wrench.levers.empty();
  if (turned) {
    for (int j = 0; j < 3; ++j) {
      for (int l = 0; l < 3; ++l) {
        const Vector3<T> axis = Vector3<T>::Unit(l);
        Array4& column = e.turning[static_cast<std::size_t>(3 * j + l)];
        column = e.inv_I * lanes<T>(tau_W_[j] * axis + e.moments.col(j).cross(axis));
        square = std::max(square, maxAbs(column));
      }
    }
  }
  T rate = std::max(maxAbs(e.w_P), std::sqrt(square));
  if (!wrench.pulls.empty()) {
    const T jerk = e.v_W.cross(e.pull_W).cwiseAbs().maxCoeff() * maxAbs(e.inv_I);
    const T snap = a_W_.cross(e.pull_W).cwiseAbs().maxCoeff() * maxAbs(e.inv_I);
    rate = std::max(std::max(rate, std::cbrt(jerk)), std::sqrt(std::sqrt(snap)));
  }
  degree_ = degreeFor<T>(rate * horizon, kOrder);
  rate_unit_ = unitOf(rate);
  const T time_unit = T(1) / rate_unit_;
  if (!wrench.pulls.empty()) {
    expand<true, true>(e, time_unit);
  } else if (turned || body_force_ || body_torque_) {
    expand<true, false>(e, time_unit);
  } else {
    expand<false, false>(e, time_unit);
  }
}

template <class T>
template <bool kTurned, bool kPulled>
void TaylorSegmentT<T>::expand(const Equations& e, T time_unit) {
  const std::size_t N = degree_;
  // ω and q once more, with the components in the places where the products need them
  std::array<Array4, kOrder> q_x, q_y, q_z;
  Rotations R;
  std::array<Array4, 9> turning;
  Torques pull_torque;

  w_[0] = e.w_P * time_unit;
  q_[0] = start_.q_WP.coeffs().array();
  const Array4 alpha_P = e.alpha_P * time_unit * time_unit;
  if (kTurned)
    for (std::size_t j = 0; j < 9; ++j) turning[j] = e.turning[j] * time_unit * time_unit;
  const Array4 inv_I = kPulled ? Array4(e.inv_I * time_unit * time_unit) : e.inv_I;
  if (kTurned) pull_torque.fill(Vector3<T>::Zero());
  if (kPulled) {
    pull_torque[1] = e.pull_W.cross(e.v_W) * time_unit;
    pull_torque[2] = e.pull_W.cross(a_W_) * (time_unit * time_unit / T(2));
  }
  const Array4 sign_x(1, 1, -1, -1), sign_y(-1, 1, 1, -1), sign_z(1, -1, 1, -1);
  T last_R = T(0);
  for (std::size_t k = 0; k < N; ++k) {
    const Array4& q = q_[k];
    q_x[k] = q.reverse();
    q_y[k].template head<2>() = q.template tail<2>();
    q_y[k].template tail<2>() = q.template head<2>();
    q_z[k] = q_y[k].reverse();

    // the newest coefficients last: the sums of the others need not wait for them
    T ww_x = T(0), ww_y = T(0), ww_z = T(0);
    Array4 qw_x = Array4::Zero(), qw_y = Array4::Zero(), qw_z = Array4::Zero();
    const auto addRates = [&](std::size_t i) {
      const Array4& v = w_[k - i];
      ww_x += w_[i][1] * v[2];
      ww_y += w_[i][2] * v[0];
      ww_z += w_[i][0] * v[1];
      qw_x += q_x[i] * v[0];
      qw_y += q_y[i] * v[1];
      qw_z += q_z[i] * v[2];
    };
    for (std::size_t i = 1; i < k; ++i) addRates(i);
    Array4 xq = Array4::Zero(), yq = Array4::Zero(), zq = Array4::Zero();
    if (kTurned) {
      const auto addProducts = [&](std::size_t i) {
        const Array4& p = q_[k - i];
        xq += q_[i] * p[0];
        yq += q_[i] * p[1];
        zq += q_[i] * p[2];
      };
      for (std::size_t i = 1; i < k; ++i) addProducts(i);
      addProducts(0);
      if (k > 0) addProducts(k);
    }
    addRates(0);
    if (k > 0) addRates(k);
    Array4 alpha = e.gyroscopic * Array4(ww_x, ww_y, ww_z, T(0));
    if (k == 0) alpha += alpha_P;
    if (kTurned) {
      setRotationMatrix<T>(k == 0 ? T(1) : T(0), xq, yq, zq, R[k]);
      Array4 rows[3];
      for (std::size_t j = 0; j < 3; ++j)
        rows[j] = turning[3 * j] * R[k](int(j), 0) + turning[3 * j + 1] * R[k](int(j), 1) +
                  turning[3 * j + 2] * R[k](int(j), 2);
      alpha += rows[0] + (rows[1] + rows[2]);
      if (k + 1 == N) last_R = std::max(maxAbs(xq), std::max(maxAbs(yq), maxAbs(zq)));
    }
    if (kPulled) {
      const std::size_t last = body_force_ ? k : std::min<std::size_t>(k, 2);
      if (body_force_ && k + 2 < N)
        pull_torque[k + 2] +=
            e.pull_W.cross(R[k] * e.f_P) *
            (inv_mass_ * time_unit * time_unit * kInverse<T>[k + 1] * kInverse<T>[k + 2]);
      Vector3<T> torque_P = Vector3<T>::Zero();
      for (std::size_t i = 1; i <= last; ++i) torque_P += R[k - i].transpose() * pull_torque[i];
      alpha += inv_I * lanes<T>(torque_P);
    }
    const T inverse = kInverse<T>[k + 1];
    w_[k + 1] = alpha * inverse;
    q_[k + 1] = (qw_x * sign_x + (qw_y * sign_y + qw_z * sign_z)) * (inverse / T(2));
  }

  if (kTurned) integrate(e, time_unit, R, pull_torque);
  valid_for_ = length(last_R) * time_unit;
}

template <class T>
void TaylorSegmentT<T>::integrate(const Equations& e, T time_unit, const Rotations& R,
                                  const Torques& pull_torque) {
  if (body_force_) {
    momentum_[0].setZero();
    displacement_[0].setZero();
    displacement_[1].setZero();
    for (std::size_t k = 0; k < degree_; ++k) {
      momentum_[k + 1] = lanes<T>(R[k] * e.f_P) * (time_unit * kInverse<T>[k + 1]);
      if (k + 2 <= degree_)
        displacement_[k + 2] = momentum_[k + 1] * (inv_mass_ * time_unit * kInverse<T>[k + 2]);
    }
  }
  if (body_torque_) {
    angular_impulse_[0].setZero();
    for (std::size_t k = 0; k < degree_; ++k) {
      Vector3<T> torque_W = R[k] * e.tau_P + turnedMoment<T>(R[k], e.moments);
      if (k > 0) torque_W += pull_torque[k];
      angular_impulse_[k + 1] = lanes<T>(torque_W) * (time_unit * kInverse<T>[k + 1]);
    }
  }
}

template <class T>
T TaylorSegmentT<T>::length(T last_R) const {
  // How far the last terms stay at rounding. At the best step successive terms shrink by e²
  // (Jorba and Zou), which the last but one is allowed, and which the first left out has on top.
  const std::size_t N = degree_;
  constexpr T kLast = std::numeric_limits<T>::epsilon();
  constexpr T kLastButOne = T(7) * kLast;
  const auto lengthOf = [&](T last, T before) {
    return std::min(std::pow(kLast / last, kInverse<T>[N]),
                    std::pow(kLastButOne / before, kInverse<T>[N - 1]));
  };
  // last_R/N is the last coefficient of what the turned vectors integrate to
  T s = lengthOf(maxAbs(q_[N]), std::max(maxAbs(q_[N - 1]), T(7) * last_R * kInverse<T>[N]));
  const Array4 I4 = lanes<T>(I_);
  const T size = std::max(maxAbs(w_[0]), std::max(maxAbs(w_[1]) * s, maxAbs(w_[2]) * s * s));
  const T size_L = std::max(maxAbs<T>(I4 * w_[0]),
                            std::max(maxAbs<T>(I4 * w_[1]) * s, maxAbs<T>(I4 * w_[2]) * s * s));
  const auto ratio = [&](std::size_t n) {
    return std::max(maxAbs(w_[n]) / size, maxAbs<T>(I4 * w_[n]) / size_L);
  };
  if (size > T(0)) s = std::min(s, lengthOf(ratio(N), ratio(N - 1)));
  return s;
}

template <class T>
BodyStateT<T> TaylorSegmentT<T>::at(T dt) const {
  const T s = rate_unit_ * dt;
  // Horner's rule without the constant term
  const auto increment = [this, s](const Series& series) {
    Array4 sum = series[degree_];
    for (std::size_t k = degree_ - 1; k > 0; --k) sum = series[k] + s * sum;
    return Array4(s * sum);
  };
  BodyStateT<T> state;
  const Array4 dw = increment(w_) * rate_unit_;
  state.L_P = start_.L_P + I_.cwiseProduct(Vector3<T>(dw[0], dw[1], dw[2]));
  state.q_WP.coeffs() = (q_[0] + increment(q_)).matrix();
  renormalize(state.q_WP);
  state.L_W = start_.L_W;
  Vector3<T> dL = tau_W_ * dt;
  if (body_torque_) dL += increment(angular_impulse_).matrix().template head<3>();
  state.L_W += dL;

  Vector3<T> dp = f_W_ * dt;
  Vector3<T> dx = (start_.p_W * inv_mass_ + a_W_ * (dt / T(2))) * dt;
  if (body_force_) {
    dp += increment(momentum_).matrix().template head<3>();
    dx += increment(displacement_).matrix().template head<3>();
  }
  state.p_W = start_.p_W + dp;
  const Vector3<T> low = start_.x_low_W + dx;
  state.x_W = start_.x_W + low;
  const Vector3<T> part = state.x_W - start_.x_W;
  state.x_low_W = (start_.x_W - (state.x_W - part)) + (low - part);
  return state;
}

template class TaylorSegmentT<double>;
template class TaylorSegmentT<long double>;

}  // namespace rigid_body_sim
