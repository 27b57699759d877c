#include "dynamics/taylor/taylor_segment.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/taylor/series_length.hpp"
#include "dynamics/taylor/taylor_recursion.hpp"
#include "dynamics/taylor/taylor_terms.hpp"
#include "math/always_inline.hpp"
#include "math/two_sum.hpp"

namespace rigid_body_sim {
namespace {

template <class T, int n>
Vector3<T> vectorOf(const T (&lanes)[n]) {
  return Vector3<T>(lanes[0], lanes[1], lanes[2]);
}

template <class T, int n, class V>
void assign(T (&to)[n], const V& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
  if (n == 4) to[n - 1] = T(0);
}

template <class T>
RIGID_BODY_SIM_INLINE T maxAbs(const T (&lanes)[4]) {
  return std::max(std::max(std::abs(lanes[0]), std::abs(lanes[1])),
                  std::max(std::abs(lanes[2]), std::abs(lanes[3])));
}

/// [1/s] At what accelerations of these sizes change the motion.
template <class T>
T rateOf(const TaylorEquations<T>& equations) {
  T square = maxAbs(equations.steady);
  for (const T(&column)[4] : equations.turning) square = std::max(square, maxAbs(column) / T(2));
  return std::sqrt(square);
}

template <class T>
T rateOf(const TaylorPull<T>& pull) {
  const T inv_I = vectorOf(pull.inv_I).maxCoeff();
  return std::max(
      std::cbrt(vectorOf(pull.linear_W).cwiseAbs().maxCoeff() * inv_I),
      std::sqrt(std::sqrt(T(2) * vectorOf(pull.quadratic_W).cwiseAbs().maxCoeff() * inv_I)));
}

/// From units of the scene to those in which time is measured in time_unit.
template <class T>
TaylorEquations<T> scaled(TaylorEquations<T> equations, T time_unit) {
  for (T& lane : equations.steady) lane = lane * time_unit * time_unit;
  for (T(&column)[4] : equations.turning)
    for (T& lane : column) lane = lane * time_unit * time_unit;
  return equations;
}

template <class T>
TaylorPull<T> scaled(TaylorPull<T> pull, T time_unit) {
  for (int i = 0; i < 3; ++i) {
    pull.inv_I[i] = pull.inv_I[i] * time_unit * time_unit;
    pull.linear_W[i] *= time_unit;
    pull.quadratic_W[i] = pull.quadratic_W[i] * time_unit * time_unit;
    pull.acceleration_P[i] = pull.acceleration_P[i] * time_unit * time_unit;
  }
  return pull;
}

}  // namespace

template <class T>
TaylorSegmentT<T>::TaylorSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                                  const BodyStateT<T>& start, T horizon, const ErrorBound& bound)
    : TaylorSegmentT(body, wrench, g_W, bound) {
  startAnew(wrench, start, horizon);
}

template <class T>
TaylorSegmentT<T>::TaylorSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                                  const ErrorBound& bound)
    : inv_I_(body.I.template cast<T>().cwiseInverse()),
      inv_mass_(T(1) / T(body.mass)),
      f_P_(wrench.f_P.template cast<T>()),
      pulled_(!wrench.world_point_forces.empty()),
      body_force_(!wrench.f_P.isZero(0)),
      bound_(bound),
      I_(body.I.template cast<T>()),
      f_W_(wrench.f_W.template cast<T>() + T(body.mass) * g_W.template cast<T>()),
      a_W_(wrench.f_W.template cast<T>() * inv_mass_ + g_W.template cast<T>()),
      tau_W_(wrench.tau_W.template cast<T>()),
      tau_P_(wrench.tau_P.template cast<T>()),
      moments_(Matrix3<T>::Zero()),
      body_torque_(!wrench.tau_P.isZero(0) || !wrench.body_point_forces.empty() ||
                   !wrench.world_point_forces.empty()) {
  turned_ = body_force_ || body_torque_ || !tau_W_.isZero(0);
  for (const HeldWrench::BodyPointForce& force : wrench.body_point_forces)
    moments_ += force.arm_P.template cast<T>() * force.force_W.template cast<T>().transpose();
  if (!pulled_) setUpEquations();
}

template <class T>
void TaylorSegmentT<T>::startAnew(const HeldWrench& same_wrench, const BodyStateT<T>& start,
                                  T horizon) {
  const T rate = begin(same_wrench, start, T(0));
  const T angle = rate * horizon;
  const T precision = precisionFor(rate, angle);
  degree_ = degreeFor(angle, precision, kHighestTaylorDegree);
  expand();
  valid_for_ = length(precision) / rate_unit_;
}

template <class T>
void TaylorSegmentT<T>::expand() {
  if (pulled_) {
    TaylorEquations<T> equations = scaledEquations();
    const TaylorPull<T> pull = scaledPull();
    equations.pull = &pull;
    return expandTaylor(equations, turned_, degree_, series_);
  }
  if (scaled_to_ != rate_unit_) {
    scaled_ = scaledEquations();
    scaled_to_ = rate_unit_;
  }
  expandTaylor(scaled_, turned_, degree_, series_);
}

template <class T>
T TaylorSegmentT<T>::begin(const HeldWrench& wrench, const BodyStateT<T>& start, T rate) {
  start_ = start;
  if (pulled_) setUpPull(wrench);
  assign(series_.w[0], start.L_P.cwiseProduct(inv_I_));
  for (int i = 0; i < 4; ++i) series_.q[0][i] = start.q_WP.coeffs()[i];

  rate = std::max(rate, std::max(maxAbs(series_.w[0]), equations_rate_));
  rate_unit_ = unitOf(rate);
  const T time_unit = T(1) / rate_unit_;
  for (T& lane : series_.w[0]) lane *= time_unit;
  return rate;
}

template <class T>
TaylorEquations<T> TaylorSegmentT<T>::scaledEquations() const {
  return scaled(equations_, T(1) / rate_unit_);
}

template <class T>
TaylorPull<T> TaylorSegmentT<T>::scaledPull() const {
  return scaled(pull_, T(1) / rate_unit_);
}

/// A segment shorter than a radian has its part of the share.
template <class T>
T TaylorSegmentT<T>::precisionFor(T rate, T angle) const {
  const T share = shareOf(T(bound_.attitude), rate * T(bound_.horizon));
  return std::max(std::numeric_limits<T>::epsilon(), share * std::min(angle, T(1)));
}

template <class T>
void TaylorSegmentT<T>::setUpEquations() {
  TaylorEquations<T>& e = equations_;
  assign(e.gyroscopic,
         Vector3<T>((I_[1] - I_[2]) / I_[0], (I_[2] - I_[0]) / I_[1], (I_[0] - I_[1]) / I_[2]));
  // I⁻¹ × torque in P = I⁻¹ tau_P + Σ R(j, l) column(j, l)
  const auto column = [&](int j, int l) -> Vector3<T> {
    const T t = tau_W_[j], x = moments_(0, j), y = moments_(1, j), z = moments_(2, j);
    const Vector3<T> torque = l == 0   ? Vector3<T>(t, z, -y)
                              : l == 1 ? Vector3<T>(-z, t, x)
                                       : Vector3<T>(y, -x, t);
    return inv_I_.cwiseProduct(torque);
  };
  e.turns = !tau_W_.isZero(0) || !moments_.isZero(0);
  const Vector3<T> xx = column(0, 0), yy = column(1, 1), zz = column(2, 2);
  assign(e.steady, inv_I_.cwiseProduct(tau_P_) + (xx + yy + zz));
  assign(e.turning[0], T(-2) * (yy + zz));
  assign(e.turning[1], T(-2) * (xx + zz));
  assign(e.turning[2], T(-2) * (xx + yy));
  for (int n = 0; n < 3; ++n) {
    const int j = n, l = (n + 1) % 3, left = (n + 2) % 3;
    assign(e.turning[3 + n], T(2) * (column(j, l) + column(l, j)));
    assign(e.turning[6 + left], T(2) * (column(l, j) - column(j, l)));
  }
  equations_rate_ = rateOf(e);
}

/// Forces at world points: their torque at the start counts as a couple, what the displacement adds
/// to it goes by itself.
template <class T>
void TaylorSegmentT<T>::setUpPull(const HeldWrench& wrench) {
  tau_W_ = wrench.tau_W.template cast<T>();
  Vector3<T> pull_W = Vector3<T>::Zero();
  for (const HeldWrench::WorldPointForce& pull : wrench.world_point_forces) {
    const Vector3<T> force_W = pull.force_W.template cast<T>();
    pull_W += force_W;
    tau_W_ += ((pull.point_W.template cast<T>() - start_.x_W) - start_.x_low_W).cross(force_W);
  }
  setUpEquations();
  assign(pull_.force_W, pull_W);
  assign(pull_.linear_W, pull_W.cross(start_.p_W * inv_mass_));
  assign(pull_.quadratic_W, pull_W.cross(a_W_ / T(2)));
  assign(pull_.acceleration_P, f_P_ * inv_mass_);
  assign(pull_.inv_I, inv_I_);
  equations_rate_ = std::max(equations_rate_, rateOf(pull_));
}

template <class T>
T TaylorSegmentT<T>::length(T size) const {
  // How far the last terms stay small. At the best step successive terms shrink by e² (Jorba and
  // Zou), which the last but one is allowed, and which the first left out has on top.
  const std::size_t N = degree_;
  T products = T(0);
  if (turned_)
    products = std::max(std::max(maxAbs(series_.squares[N]), maxAbs(series_.crosses[N])),
                        maxAbs(series_.turns[N]));
  const auto& w = series_.w;
  const auto sizeOf = [&](std::size_t n) { return maxAbs(w[n]); };
  const auto sizeOfL = [&](std::size_t n) {
    return vectorOf(w[n]).cwiseProduct(I_).cwiseAbs().maxCoeff();
  };
  // relative to the sizes that ω and L reach in one unit of time
  const T size_w = std::max(sizeOf(0), std::max(sizeOf(1), sizeOf(2)));
  const T size_L = std::max(sizeOfL(0), std::max(sizeOfL(1), sizeOfL(2)));
  T last = maxAbs(series_.q[N]), before = std::max(maxAbs(series_.q[N - 1]), T(7) * products);
  if (size_w > T(0)) {
    last = std::max(last, std::max(sizeOf(N) / size_w, sizeOfL(N) / size_L));
    before = std::max(before, std::max(sizeOf(N - 1) / size_w, sizeOfL(N - 1) / size_L));
  }
  if (last > T(0) || before > T(0)) return lengthBy(last, before, size, T(1));
  const auto larger = [&](std::size_t n) {
    const T turn = maxAbs(series_.q[n]);
    return size_w > T(0) ? std::max({turn, sizeOf(n) / size_w, sizeOfL(n) / size_L}) : turn;
  };
  return lengthByEarlier(larger, N, size, T(1));
}

template <class T>
T TaylorSegmentT<T>::lengthBy(T last, T before, T size, T own) const {
  const std::size_t N = degree_;
  size = std::max(size * own, std::numeric_limits<T>::min());  // below, digits are lost anyway
  const T s = nthRoot(size / last, N);
  // before sᴺ⁻¹ <= 7 size, with sᴺ = size/last
  if (before <= T(7) * last * s) return s;
  return std::min(s, nthRoot(T(7) * size / before, N - 1));
}

template <class T>
BodyStateT<T> TaylorSegmentT<T>::at(T dt) const {
  const T s = rate_unit_ * dt, time_unit = T(1) / rate_unit_;
  TaylorIncrements<T> gain;
  const TaylorGains wanted = body_force_ ? TaylorGains::kIntegrals
                             : turned_   ? TaylorGains::kProducts
                                         : TaylorGains::kMotion;
  evaluateTaylor(series_, wanted, degree_, s, gain);
  BodyStateT<T> state;
  state.L_P = start_.L_P + I_.cwiseProduct(vectorOf(gain.w) * rate_unit_);
  for (int i = 0; i < 4; ++i) state.q_WP.coeffs()[i] = series_.q[0][i] + gain.q[i];
  renormalize(state.q_WP);
  Vector3<T> dL = tau_W_ * dt;
  Vector3<T> dp = f_W_ * dt;
  Vector3<T> dx = (start_.p_W * inv_mass_ + a_W_ * (dt / T(2))) * dt;
  if (body_force_ || body_torque_) {
    Matrix3<T> R;  // its integral over time
    setRotationMatrix(s, gain.squares, gain.crosses, gain.turns, R);
    R *= time_unit;
    if (body_torque_) dL += R * tau_P_ + turnedMoment(R, moments_);
    if (pulled_) dL += pulledMoment(s) * time_unit;
    if (body_force_) {
      dp += R * f_P_;
      dx += bodyDisplacement(s, gain);
    }
  }
  state.L_W = start_.L_W + dL;
  state.p_W = start_.p_W + dp;
  state.x_W = twoSum(start_.x_W, Vector3<T>(start_.x_low_W + dx), state.x_low_W);
  return state;
}

/// The time integral of the torque of forces at world points, but for its part in tau_W.
template <class T>
Vector3<T> TaylorSegmentT<T>::pulledMoment(T s) const {
  Vector3<T> sum = vectorOf(series_.pull[degree_]);
  for (std::size_t k = degree_ - 1; k > 0; --k) sum = vectorOf(series_.pull[k]) + s * sum;
  return s * sum;
}

/// [m] f_P/m × the integral over time of the integral of R.
template <class T>
Vector3<T> TaylorSegmentT<T>::bodyDisplacement(T s, const TaylorIncrements<T>& gain) const {
  Matrix3<T> R;
  setRotationMatrix(s * s / T(2), gain.integrals.squares, gain.integrals.crosses,
                    gain.integrals.turns, R);
  return R * (f_P_ * inv_mass_ / (rate_unit_ * rate_unit_));
}

template class TaylorSegmentT<double>;
template class TaylorSegmentT<long double>;

}  // namespace rigid_body_sim
