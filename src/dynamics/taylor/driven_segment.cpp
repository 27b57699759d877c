#include "dynamics/taylor/driven_segment.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/taylor/series_length.hpp"
#include "dynamics/taylor/taylor_recursion.hpp"
#include "dynamics/taylor/taylor_terms.hpp"
#include "math/two_sum.hpp"

namespace rigid_body_sim {
namespace {

/// Of the series: shorter segments than the highest, since commands come every few milliseconds.
constexpr std::size_t kDrivenDegree = 16;

template <class T>
using Lane = T[4];

template <class T>
Vector3<T> drivenVector(const Lane<T>& lanes) {
  return Vector3<T>(lanes[0], lanes[1], lanes[2]);
}

template <class T, class V>
void addTo(Lane<T>& lanes, T factor, const V& v) {
  for (int i = 0; i < 3; ++i) lanes[i] += factor * T(v[i]);
}

template <class T>
void setTo(Lane<T>& lanes, const Vector3<T>& v) {
  for (int i = 0; i < 3; ++i) lanes[i] = v[i];
  lanes[3] = T(0);
}

}  // namespace

template <class T>
DrivenSegmentT<T>::DrivenSegmentT(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                                  const BodyStateT<T>& start, T since, const ErrorBound& bound)
    : Base(body, wrench, g_W, bound) {
  this->turned_ = true;
  this->body_force_ = false;  // part of the drive
  startAnew(wrench, start, since);
}

template <class T>
void DrivenSegmentT<T>::startAnew(const HeldWrench& same_wrench, const BodyStateT<T>& start,
                                  T since) {
  const T rate = this->begin(same_wrench, start, driveRate(*same_wrench.drive, since));
  const T precision = this->precisionFor(rate, T(1));
  this->degree_ = degreeFor(T(1), precision, kDrivenDegree);
  setUpDrive(same_wrench, since);
  TaylorEquations<T> equations = this->scaledEquations();
  TaylorPull<T> pull;
  if (this->pulled_) {
    pull = this->scaledPull();
    for (T& lane : pull.acceleration_P) lane = T(0);  // what the drive pushes has its own series
    equations.pull = &pull;
  }
  expandDriven(equations, drive_, this->degree_, this->series_);
  const T s = std::min({this->length(precision), lengthOf(drive_.impulse, precision),
                        lengthOf(drive_.twist, precision)});
  this->valid_for_ = s / this->rate_unit_;
}

/// [1/s] At which the drive changes the motion: by lags, by precession about the momentum, and by
/// its torque.
template <class T>
T DrivenSegmentT<T>::driveRate(const ActuatorDrive& drive, T since) const {
  const ActuatorDrive::Value now = drive.at(double(since));
  const Vector3<T> H = now.H_P.cast<T>(), torque = (now.tau_P - now.H_dot_P).cast<T>();
  T rate = std::max(this->inv_I_.cwiseProduct(H).cwiseAbs().maxCoeff(),
                    std::sqrt(this->inv_I_.cwiseProduct(torque).cwiseAbs().maxCoeff()));
  for (const ActuatorDrive::Lag& lag : drive.lags) rate = std::max(rate, T(2 * lag.rate));
  return rate;
}

template <class T>
void DrivenSegmentT<T>::setUpDrive(const HeldWrench& wrench, T since) {
  const ActuatorDrive& drive = *wrench.drive;
  const T time_unit = T(1) / this->rate_unit_;
  const std::size_t terms = this->degree_ + 1;
  for (auto* series : {&drive_.force, &drive_.torque, &drive_.momentum})
    for (std::size_t n = 0; n < terms; ++n)
      for (T& lane : (*series)[n]) lane = T(0);
  addTo(drive_.force[0], T(1), this->f_P_);
  addTo(drive_.force[0], T(1), drive.f_0);
  addTo(drive_.torque[0], T(1), drive.tau_0);
  addTo(drive_.momentum[0], time_unit, drive.H_0);
  addTo(drive_.momentum[0], time_unit * since, drive.H_1);
  addTo(drive_.momentum[1], time_unit * time_unit, drive.H_1);
  for (const ActuatorDrive::Lag& lag : drive.lags) addDecay(lag, since);
  const std::size_t lagging = drive.lags.empty() ? 1 : terms;
  drive_.force_terms = lagging;
  drive_.torque_terms = drive.turns() ? lagging : 0;
  drive_.momentum_terms = drive.spins() ? std::max<std::size_t>(lagging, 2) : 0;
  setTo(drive_.inv_I, this->inv_I_);
  drive_.inv_mass = this->inv_mass_ * time_unit * time_unit;
  findAcceleration();
}

/// ε = exp(−rate (since + time_unit s)) and ε² as series in s.
template <class T>
void DrivenSegmentT<T>::addDecay(const ActuatorDrive::Lag& lag, T since) {
  const T time_unit = T(1) / this->rate_unit_;
  const T rate = T(lag.rate), step = -rate * time_unit;
  T once = std::exp(-rate * since), twice = once * once;
  for (std::size_t n = 0; n <= this->degree_; ++n) {
    if (n > 0) once *= step * kInverse<T>[n];
    if (n > 0) twice *= T(2) * step * kInverse<T>[n];
    addTo(drive_.force[n], once, lag.f_1);
    addTo(drive_.force[n], twice, lag.f_2);
    addTo(drive_.torque[n], once, lag.tau_1);
    addTo(drive_.torque[n], twice, lag.tau_2);
    addTo(drive_.momentum[n], once * time_unit, lag.H_2);
  }
}

/// I⁻¹ (τ − H′), from degree to degree.
template <class T>
void DrivenSegmentT<T>::findAcceleration() {
  const T time_unit = T(1) / this->rate_unit_, squared = time_unit * time_unit;
  for (std::size_t n = 0; n < this->degree_; ++n) {
    const Vector3<T> torque =
        squared * drivenVector(drive_.torque[n]) - T(n + 1) * drivenVector(drive_.momentum[n + 1]);
    setTo(drive_.acceleration[n], Vector3<T>(this->inv_I_.cwiseProduct(torque)));
  }
}

/// How long, in time units, the last terms stay below a relative size.
template <class T>
T DrivenSegmentT<T>::lengthOf(const typename TaylorDrive<T>::Coefficients& series, T size) const {
  const std::size_t N = this->degree_;
  const auto sizeOf = [&](std::size_t n) { return drivenVector(series[n]).cwiseAbs().maxCoeff(); };
  const T last = sizeOf(N), before = sizeOf(N - 1);
  T own = std::max(sizeOf(1), std::max(sizeOf(2), sizeOf(3)));
  if (!(own > T(0))) own = std::max(last, before);
  if (own == T(0)) return std::numeric_limits<T>::infinity();
  if (last > T(0) || before > T(0)) return this->lengthBy(last, before, size, own);
  return lengthByEarlier(sizeOf, N, size, own);
}

template <class T>
BodyStateT<T> DrivenSegmentT<T>::at(T dt) const {
  BodyStateT<T> state = Base::at(dt);
  const T s = this->rate_unit_ * dt, time_unit = T(1) / this->rate_unit_;
  Vector3<T> twist = Vector3<T>::Zero(), impulse = twist, way = twist;
  for (std::size_t k = this->degree_; k > 0; --k) {
    const Vector3<T> c = drivenVector(drive_.impulse[k]);
    impulse = c + s * impulse;
    way = c * (T(1) / T(k + 1)) + s * way;
    twist = drivenVector(drive_.twist[k]) + s * twist;
  }
  state.p_W += (s * time_unit) * impulse;
  state.L_W += (s * time_unit) * twist;
  const T share = s * s * time_unit * time_unit * this->inv_mass_;
  state.x_W = twoSum(state.x_W, Vector3<T>(state.x_low_W + share * way), state.x_low_W);
  return state;
}

template class DrivenSegmentT<double>;
template class DrivenSegmentT<long double>;

}  // namespace rigid_body_sim
