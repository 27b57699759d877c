#include "dynamics/medium/medium_segment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/taylor/series_length.hpp"
#include "dynamics/taylor/taylor_terms.hpp"
#include "math/two_sum.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::size_t kDegree = MediumSeries::kDegree;
constexpr double kAnyLength = std::numeric_limits<double>::infinity();

/// Σ of the terms from degree 1 on.
template <class Value>
Value gain(const MediumSeries::Of<Value>& series, double s) {
  Value sum = series[kDegree];
  for (std::size_t n = kDegree - 1; n > 0; --n) sum = series[n] + s * sum;
  return s * sum;
}

/// How far a series holds to a precision of its size: at the best step successive terms shrink by
/// e² (Jorba and Zou), which the last but one is allowed. Not at all where it overflows.
template <class Value>
double lengthOf(const MediumSeries::Of<Value>& series, double precision) {
  const auto size = [&](std::size_t n) { return series[n].cwiseAbs().maxCoeff(); };
  double own = 0;
  for (std::size_t n = 0; n < kDegree && (n < 3 || own == 0); ++n) own = std::max(own, size(n));
  const double last = size(kDegree), before = size(kDegree - 1);
  if (!std::isfinite(last) || !std::isfinite(before)) return 0;
  if (last == 0 && before == 0) return lengthByEarlier(size, kDegree, precision, own);
  return std::min(lengthByTerm(last, kDegree, precision, own),
                  lengthByTerm(before, kDegree - 1, 7 * precision, own));
}

}  // namespace

MediumSegment::MediumSegment(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                             const BodyState& start, const ErrorBound& bound)
    : tau_W_(wrench.tau_W), bound_(bound) {
  equations_.I = body.I;
  equations_.inv_I = body.inv_I;
  equations_.inv_mass = 1 / body.mass;
  equations_.load = *wrench.medium;
  equations_.a_W = g_W + (wrench.f_W + wrench.medium->lift_W) * equations_.inv_mass;
  equations_.f_P = wrench.f_P;
  equations_.tau_P = wrench.tau_P;
  equations_.moments = wrench.medium->lift_arm_P * wrench.medium->lift_W.transpose();
  for (const HeldWrench::BodyPointForce& force : wrench.body_point_forces)
    equations_.moments += force.arm_P * force.force_W.transpose();
  takeTranslationOut(wrench);
  startAnew(wrench, start);
}

/// Where no force depends on the attitude and no torque on the place: of the series, nothing moves.
void MediumSegment::takeTranslationOut(const HeldWrench& wrench) {
  MediumLoad& load = equations_.load;
  if (!load.isOfTranslation() || load.quadratic != 0 || !wrench.f_P.isZero(0) ||
      !wrench.world_point_forces.empty())
    return;
  translation_.emplace(1 / equations_.inv_mass, load.linear * equations_.inv_mass, equations_.a_W,
                       load.velocity_W);
  load.linear = 0;
  load.velocity_W.setZero();
  equations_.a_W.setZero();
}

void MediumSegment::startAnew(const HeldWrench& same_wrench, const BodyState& start) {
  start_ = start;
  setUpPulls(same_wrench);
  series_.w[0] = angularVelocity(equations_.inv_I, start.L_P);
  series_.q[0] = start.q_WP.coeffs();
  for (int j = 0; j < 3; ++j)
    series_.axes[0].col(j) = rotateBack(start.q_WP, Vector3d(Vector3d::Unit(j)));
  series_.v[0] = start.p_W * equations_.inv_mass - equations_.load.velocity_W;
  if (translation_) series_.v[0].setZero();
  stopWhatDecayed();
  setUpRate();
  expandMedium(equations_, series_);

  const double share = shareOf(bound_.attitude, fastest_ * bound_.horizon);
  valid_for_ = length(std::max(std::numeric_limits<double>::epsilon(), share)) / equations_.rate;
}

/// What drag has slowed to nothing is at rest: its series would lose their terms to underflow, and
/// in numbers that small nothing decays any more. Far above the smallest, for what the recursion
/// multiplies by 1/I on the way.
void MediumSegment::stopWhatDecayed() {
  constexpr double kAtRest = 1e-250;  // [rad/s], [m/s]
  const MediumLoad& load = equations_.load;
  const bool slows_turning = !load.angular_P.isZero(0) || !load.center_P.isZero(0);
  if (slows_turning && series_.w[0].cwiseAbs().maxCoeff() < kAtRest) {
    series_.w[0].setZero();
    start_.L_P.setZero();
  }
  const double speed = series_.v[0].cwiseAbs().maxCoeff();
  if (speed > 0 && speed < kAtRest) {
    series_.v[0].setZero();
    start_.p_W = load.velocity_W / equations_.inv_mass;
  }
}

/// Forces at points of the world: their torque at the start counts as a couple.
void MediumSegment::setUpPulls(const HeldWrench& wrench) {
  equations_.tau_W = tau_W_;
  equations_.pull_W.setZero();
  for (const HeldWrench::WorldPointForce& pull : wrench.world_point_forces) {
    equations_.pull_W += pull.force_W;
    equations_.tau_W += ((pull.point_W - start_.x_W) - start_.x_low_W).cross(pull.force_W);
  }
}

/// The unit of time, from what changes the motion fastest; and whether the body is so slow that
/// quadratic drag, which has a kink at rest, is left out.
void MediumSegment::setUpRate() {
  const MediumLoad& load = equations_.load;
  const Vector3d u = series_.axes[0] * series_.v[0] + series_.w[0].cross(load.center_P);
  const double speed = speedOf(u), arm = load.center_P.norm(), inv_I = equations_.inv_I.maxCoeff();
  const double mobility = equations_.inv_mass + arm * arm * inv_I, spin = series_.w[0].norm();
  const double quadratic = load.quadratic + load.quadratic_axes.maxCoeff();
  const double drag = load.linear + load.linear_P.cwiseAbs().maxCoeff() + quadratic * speed;
  const double torque = equations_.tau_W.norm() + equations_.tau_P.norm() +
                        equations_.moments.norm() + load.angular_P.norm() * spin;
  const double acceleration = equations_.a_W.norm() + equations_.f_P.norm() * equations_.inv_mass +
                              drag * speed * mobility + arm * (torque * inv_I + spin * spin);
  fastest_ = std::max({spin, std::sqrt((torque + arm * drag * speed) * inv_I), drag * mobility,
                       load.angular_P.cwiseAbs().maxCoeff() * inv_I,
                       std::sqrt(quadratic * mobility) * std::sqrt(acceleration)});
  small_speed_ = speedBound(acceleration);
  equations_.drops_quadratic = load.quadratic > 0 && 2 * speed <= small_speed_;
  const bool has_kink = load.quadratic > 0 && !equations_.drops_quadratic;
  kink_ = has_kink ? 0.5 * speed / acceleration : kAnyLength;
  equations_.rate = unitOf(has_kink ? std::max(fastest_, acceleration / speed) : fastest_);
  equations_.speed_unit = unitOf(std::max(speed, acceleration / equations_.rate));
}

/// The speed up to which quadratic drag is below 1e-17 of what accelerates the body.
double MediumSegment::speedBound(double acceleration) const {
  const double quadratic = equations_.load.quadratic;
  return quadratic > 0 ? std::sqrt(1e-17 * acceleration / (quadratic * equations_.inv_mass)) : 0;
}

/// In units of time.
double MediumSegment::length(double precision) const {
  MediumSeries::Of<Vector3d> L;
  for (std::size_t n = 0; n <= kDegree; ++n) L[n] = series_.w[n].cwiseProduct(equations_.I);
  const double longest = std::min({lengthOf(series_.w, precision), lengthOf(L, precision),
                                   lengthOf(series_.q, precision), lengthOf(series_.v, precision)});
  if (equations_.drops_quadratic) return smallLength(longest);
  const double before_kink = std::min(longest, kink_ * equations_.rate);
  return equations_.load.quadratic_axes.isZero(0) ? before_kink : firstSignChange(before_kink);
}

/// Up to where the speed may exceed the one up to which quadratic drag is left out.
double MediumSegment::smallLength(double longest) const {
  const auto speed = [&](double s) {
    double sum = 0;
    for (std::size_t n = kDegree; n-- > 0;) sum = series_.u[n].norm() + s * sum;
    return sum;
  };
  double low = 0, high = std::min(longest, 1.0);
  if (speed(high) <= small_speed_) return high;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (speed(middle) <= small_speed_ ? low : high) = middle;
  }
  return low;
}

/// A component of the velocity through the medium, in the sense that it starts with.
double MediumSegment::through(double s, int axis) const {
  double sum = 0;
  for (std::size_t n = kDegree; n-- > 0;) sum = series_.u[n][axis] + s * sum;
  return series_.signs[axis] * sum;
}

double MediumSegment::throughRate(double s, int axis) const {
  double sum = 0;
  for (std::size_t n = kDegree; --n > 0;)
    sum = static_cast<double>(n) * series_.u[n][axis] + s * sum;
  return series_.signs[axis] * sum;
}

/// Where a component first changes its sign.
double MediumSegment::firstSignChange(double longest) const {
  constexpr double kFar = 1e6;  // of series without an end, whose powers may overflow beyond
  double first = longest;
  for (int axis = 0; axis < 3; ++axis)
    if (equations_.load.quadratic_axes[axis] > 0 && series_.signs[axis] != 0)
      first = std::min(first, signChange(axis, std::min(first, kFar), first));
  return first;
}

/// Between samples so close that the series, whose terms shrink sevenfold, is nearly a parabola
/// between them. `none`: what is returned where the sign does not change.
double MediumSegment::signChange(int axis, double end, double none) const {
  double others = 0;
  for (std::size_t n = kDegree; --n > 0;) others = end * (std::abs(series_.u[n][axis]) + others);
  if (std::abs(series_.u[0][axis]) > others) return none;
  const double least = -kZeroShare * speedOf(series_.u[0]);
  constexpr int kSamples = 8;
  constexpr double kStart = 1e-11;  // what starts at zero has left it by then
  double before = kStart * end;
  for (int k = 1; k <= kSamples; ++k) {
    double after = end * k / kSamples;
    if (through(after, axis) >= least) after = lowest(axis, before, after);
    if (through(after, axis) < least) {
      for (double m = 0.5 * (before + after); m > before && m < after; m = 0.5 * (before + after))
        (through(m, axis) < least ? after : before) = m;
      return after;
    }
    before = end * k / kSamples;
  }
  return none;
}

/// Where a component is least between two times, if that is not at one of them; else `after`.
double MediumSegment::lowest(int axis, double before, double after) const {
  double low = before, high = after;
  if (!(throughRate(low, axis) < 0 && throughRate(high, axis) > 0)) return after;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (throughRate(middle, axis) < 0 ? low : high) = middle;
  }
  return high;
}

double MediumSegment::smoothFor(double dt) const {
  return translation_ ? translation_->smoothFor(start_, dt) : valid_for_;
}

BodyState MediumSegment::at(double dt) const {
  const double s = equations_.rate * dt;
  BodyState state;
  state.L_P = start_.L_P + equations_.I.cwiseProduct(gain(series_.w, s));
  state.q_WP.coeffs() = series_.q[0] + gain(series_.q, s);
  renormalize(state.q_WP);
  state.L_W = start_.L_W + gain(series_.twist, s);
  if (translation_) {
    translation_->move(start_, dt, state);
    return state;
  }
  state.p_W = start_.p_W + gain(series_.v, s) / equations_.inv_mass;
  const Vector3d moved = gain(series_.x, s);
  state.x_W = twoSum(start_.x_W, Vector3d(start_.x_low_W + moved), state.x_low_W);
  return state;
}

}  // namespace rigid_body_sim
