#include "dynamics/contact/patch.hpp"

#include <algorithm>
#include <limits>

namespace rigid_body_sim {
namespace {

using Eigen::Vector2d;

Vector2d planePair(const double* own) { return {own[0], own[1]}; }

}  // namespace

Patch::Patch(const Feature& feature, const ContactParameters& parameters, double mass)
    : feature_(feature),
      c_(parameters),
      mass_(mass),
      lever_(feature.reach()),
      reach_(lever_),
      bristle_(Bristles::sliding(parameters, mass)),
      rolling_(Bristles::rolling(parameters, mass, lever_)) {
  const double area = feature.radius * feature.radius;
  spinning_ = {area * bristle_.stiffness, area * bristle_.damping};
}

Patch::Pose::Pose(const Body& on, const BodyState& at, const Plane& against)
    : body(on),
      state(at),
      o_W(against.half_space.origin_W),
      n_W(against.n_W),
      e1_W(against.e1_W),
      e2_W(against.e2_W),
      v_W(at.p_W / on.mass),
      w_W(rotate(at.q_WP, angularVelocity(on.inv_I, at.L_P))),
      height(n_W.dot(at.x_W - o_W)),
      height_low(n_W.dot(at.x_low_W)) {}

Patch::Now Patch::now(const Pose& pose, const double* own) const {
  Now now;
  now.mode = modeOf(own);
  now.count = feature_.pointCount();
  const PlanePoints points = planePoints(feature_, pose.state.q_WP, pose.n_W);
  for (std::size_t j = 0; j < now.count; ++j) {
    now.arm_W[j] = points.arm_W[j];
    now.point[j].depth = pose.depthAt(points.height[j]);
    now.point[j].rate = -pose.n_W.dot(pose.v_W + pose.w_W.cross(points.rate_arm_W[j]));
    now.point[j].clipped = (now.mode & (kClips << j)) != 0;
    if (now.mode & (kTouches << j)) now.normal += now.point[j].force(c_);
  }
  placeFriction(pose, now);
  return now;
}

/// Centre of pressure, and velocities there.
void Patch::placeFriction(const Pose& pose, Now& now) const {
  now.center_W = now.arm_W[0];
  if (now.count > 1 && now.normal != 0) {
    now.center_W.setZero();
    for (std::size_t j = 0; j < now.count; ++j)
      if (now.mode & (kTouches << j))
        now.center_W += now.point[j].force(c_) / now.normal * now.arm_W[j];
    for (std::size_t j = 0; j < now.count; ++j)
      if (now.mode & (kTouches << j))
        now.spread += now.point[j].force(c_) * (now.arm_W[j] - now.center_W).norm();
  }
  const Vector3d u_W = pose.v_W + pose.w_W.cross(now.center_W);
  now.v = {pose.e1_W.dot(u_W), pose.e2_W.dot(u_W)};
  now.roll = {pose.e1_W.dot(pose.w_W), pose.e2_W.dot(pose.w_W)};
  now.spin = pose.n_W.dot(pose.w_W);
}

BristlePull<Vector2d> Patch::slide(const Now& now, const double* own) const {
  return {bristle_, planePair(own + kSlideStretch), now.v, c_.friction * now.normal,
          (now.mode & kSlips) != 0};
}

BristlePull<Patch::Vector1d> Patch::spin(const Now& now, const double* own) const {
  return {spinning_, Vector1d(own[kSpinStretch]), Vector1d(now.spin), c_.friction * now.spread,
          (now.mode & kSpins) != 0};
}

BristlePull<Vector2d> Patch::roll(const Now& now, const double* own) const {
  return {rolling_, planePair(own + kRollStretch), now.roll, c_.rolling_friction * now.normal,
          (now.mode & kRolls) != 0};
}

Vector3d Patch::friction(const Pose& pose, const Now& now, const double* own) const {
  if (!bristle_.exists() || !touches(now.mode)) return Vector3d::Zero();
  const Vector2d pull = slide(now, own).pull;
  return pull[0] * pose.e1_W + pull[1] * pose.e2_W;
}

void Patch::addWrench(const Pose& pose, const double* own, Wrench& wrench) const {
  if (touches(modeOf(own))) addWrenchOf(pose, now(pose, own), own, wrench);
}

void Patch::addWrenchAndRates(const Pose& pose, const double* own, Wrench& wrench,
                              double* rates) const {
  std::fill_n(rates, kOwnCount, 0.0);
  if (!touches(modeOf(own))) return;
  const Now at = now(pose, own);
  addWrenchOf(pose, at, own, wrench);
  setRatesOf(at, own, rates);
}

void Patch::addWrenchOf(const Pose& pose, const Now& at, const double* own, Wrench& wrench) const {
  for (std::size_t j = 0; j < at.count; ++j) {
    if (!(at.mode & (kTouches << j))) continue;
    const Vector3d f_W = at.point[j].force(c_) * pose.n_W;
    wrench.f_W += f_W;
    wrench.tau_W += at.arm_W[j].cross(f_W);
  }
  const Vector3d friction_W = friction(pose, at, own);
  wrench.f_W += friction_W;
  wrench.tau_W += at.center_W.cross(friction_W);
  if (spins()) wrench.tau_W += spin(at, own).pull[0] * pose.n_W;
  if (rolling_.exists()) {
    const Vector2d pull = roll(at, own).pull;
    wrench.tau_W += pull[0] * pose.e1_W + pull[1] * pose.e2_W;
  }
}

void Patch::setRates(const Pose& pose, const double* own, double* rates) const {
  std::fill_n(rates, kOwnCount, 0.0);
  if (touches(modeOf(own))) setRatesOf(now(pose, own), own, rates);
}

void Patch::setRatesOf(const Now& at, const double* own, double* rates) const {
  if (bristle_.exists()) {
    const Vector2d rate = slide(at, own).rate;
    std::copy_n(rate.data(), 2, rates + kSlideStretch);
  }
  if (spins()) rates[kSpinStretch] = spin(at, own).rate[0];
  if (rolling_.exists()) {
    const Vector2d rate = roll(at, own).rate;
    std::copy_n(rate.data(), 2, rates + kRollStretch);
  }
}

double Patch::potentialEnergy(const Pose& pose, const double* own) const {
  if (!touches(modeOf(own))) return 0;
  const Now at = now(pose, own);
  double energy = 0.5 * (bristle_.stiffness * planePair(own + kSlideStretch).squaredNorm() +
                         spinning_.stiffness * own[kSpinStretch] * own[kSpinStretch] +
                         rolling_.stiffness * planePair(own + kRollStretch).squaredNorm());
  for (std::size_t j = 0; j < at.count; ++j)
    if (at.mode & (kTouches << j)) energy += at.point[j].energy(c_);
  return energy;
}

double Patch::externalPower(const Pose& pose, const double* own) const {
  if (!touches(modeOf(own))) return 0;
  const Now at = now(pose, own);
  double power = 0;
  for (std::size_t j = 0; j < at.count; ++j)
    if (at.mode & (kTouches << j)) power += at.point[j].externalPower(c_);
  if (bristle_.exists())
    power += slide(at, own).power(bristle_, planePair(own + kSlideStretch), at.v);
  if (spins())
    power += spin(at, own).power(spinning_, Vector1d(own[kSpinStretch]), Vector1d(at.spin));
  if (rolling_.exists())
    power += roll(at, own).power(rolling_, planePair(own + kRollStretch), at.roll);
  return power;
}

/// What slips pulls with no more than its cap q/|q|: across q it is as stiff as cap/|q| of its
/// bristle, along q not at all.
double Patch::addSwings(const Pose& pose, const double* own, Swings& swings) const {
  if (!touches(modeOf(own))) return 0;
  const Now at = now(pose, own);
  for (std::size_t j = 0; j < at.count; ++j)
    if (at.mode & (kTouches << j))
      swings.addAt(at.arm_W[j], pose.n_W, {at.point[j].stiffness(c_), at.point[j].damping(c_)});
  double relaxing = 0;
  const auto held = [&](Mode slipping, const Bristle& bristle, double cap, double excess) {
    if (!(at.mode & slipping)) return bristle;
    relaxing = std::max(relaxing, bristle.stiffness / bristle.damping);
    const double share = excess > 0 ? std::max(cap, 0.0) / (cap + excess) : 1;
    return Bristle{share * bristle.stiffness, share * bristle.damping};
  };
  if (bristle_.exists()) {
    const double cap = c_.friction * at.normal;
    const Vector2d s = planePair(own + kSlideStretch);
    const Bristle slide =
        held(kSlips, bristle_, cap, BristlePull<Vector2d>::excess(bristle_, s, at.v, cap));
    for (const Vector3d* e_W : {&pose.e1_W, &pose.e2_W}) swings.addAt(at.center_W, *e_W, slide);
  }
  if (spins()) {
    const double cap = c_.friction * at.spread;
    const Vector1d s(own[kSpinStretch]), v(at.spin);
    swings.addTurning(pose.n_W, held(kSpins, spinning_, cap,
                                     BristlePull<Vector1d>::excess(spinning_, s, v, cap)));
  }
  if (rolling_.exists()) {
    const double cap = c_.rolling_friction * at.normal;
    const Vector2d s = planePair(own + kRollStretch);
    const Bristle roll =
        held(kRolls, rolling_, cap, BristlePull<Vector2d>::excess(rolling_, s, at.roll, cap));
    for (const Vector3d* e_W : {&pose.e1_W, &pose.e2_W}) swings.addTurning(*e_W, roll);
  }
  return relaxing;
}

double Patch::longestStep(const Pose& pose, const double* own, double precision) const {
  double longest = std::numeric_limits<double>::infinity();
  if (!touches(modeOf(own))) return longest;
  const Now at = now(pose, own);
  for (std::size_t j = 0; j < at.count; ++j)
    if (at.mode & (kTouches << j))
      longest = std::min(longest, at.point[j].longestStep(c_, mass_, precision));
  return longest;
}

/// Of a patch that does not touch, by its depths alone. False where those do not tell.
bool Patch::setGuardsApart(const Pose& pose, double depth_rounding, double* guards) const {
  const PlanePoints points = planePoints(feature_, pose.state.q_WP, pose.n_W);
  for (std::size_t j = 0; j < feature_.pointCount(); ++j) {
    const double depth = pose.depthAt(points.height[j]);
    if (!(std::abs(depth) > depth_rounding)) return false;
    guards[2 * j] = -depth;
  }
  return true;
}

void Patch::setGuards(const Pose& pose, const double* own, double* guards) const {
  std::fill_n(guards, guardCount(), 1.0);
  const double depth_rounding = kDepthRounding * (pose.size() + reach_);
  if (!touches(modeOf(own)) && setGuardsApart(pose, depth_rounding, guards)) return;
  const Now at = now(pose, own);
  const auto rateRounding = [&] {
    return kDepthRounding * (pose.v_W.norm() + reach_ * pose.w_W.norm());
  };
  for (std::size_t j = 0; j < at.count; ++j) {
    const bool touching = (at.mode & (kTouches << j)) != 0;
    guards[2 * j] = at.point[j].touchGuard(touching, depth_rounding, rateRounding);
    guards[2 * j + 1] = at.point[j].pushGuard(c_, touching);
  }
  if (!touches(at.mode)) return;
  double* of_bristles = guards + 2 * at.count;
  const auto guard = [&](Mode slipping, double excess, double margin) {
    return (at.mode & slipping) ? excess : margin - excess;
  };
  const double margin = Bristles::margin(mass_);
  if (bristle_.exists())
    of_bristles[0] = guard(kSlips,
                           BristlePull<Vector2d>::excess(bristle_, planePair(own + kSlideStretch),
                                                         at.v, c_.friction * at.normal),
                           margin);
  if (spins())
    of_bristles[1] =
        guard(kSpins,
              BristlePull<Vector1d>::excess(spinning_, Vector1d(own[kSpinStretch]),
                                            Vector1d(at.spin), c_.friction * at.spread),
              margin * feature_.radius);
  if (rolling_.exists())
    of_bristles[2] = guard(kRolls,
                           BristlePull<Vector2d>::excess(rolling_, planePair(own + kRollStretch),
                                                         at.roll, c_.rolling_friction * at.normal),
                           margin * lever_);
}

void Patch::switchMode(std::size_t guard, double* own) const {
  const std::size_t points = feature_.pointCount();
  unsigned mode = modeOf(own);
  if (guard >= 2 * points) {
    mode ^= static_cast<unsigned>(kSlips) << (guard - 2 * points);
  } else if (guard % 2 == 1) {
    mode ^= static_cast<unsigned>(kClips) << (guard / 2);
  } else {
    const unsigned j = static_cast<unsigned>(guard / 2);
    const bool touched = touches(mode);
    mode ^= static_cast<unsigned>(kTouches) << j;
    mode &= ~(static_cast<unsigned>(kClips) << j);
    if (touched == touches(mode)) {
      own[kMode] = mode;
      return;
    }
    // what its bristles hold is dropped as it lets go; they start from zero as it touches
    mode &= 15U;
    std::fill_n(own, static_cast<std::size_t>(kOwnCount), 0.0);
  }
  own[kMode] = mode;
}

}  // namespace rigid_body_sim
