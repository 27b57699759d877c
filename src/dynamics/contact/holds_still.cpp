#include <algorithm>
#include <cmath>

#include "dynamics/contact/ball_contact.hpp"
#include "dynamics/contact/plane_contact.hpp"

/// ForceLaw::holdsStill of contacts: bounds on their guards.
namespace rigid_body_sim {
namespace {

/// [N] How much less than now, with 1 + d δ' > 0, a point presses at least while its depth changes
/// by at most `depth` and at a rate of at most `speed`; more than all where that bound fails. The
/// depth must not change by more than an eighth, so that the stiffness stays within a tenth.
double lossOf(const NormalPoint& point, const ContactParameters& c, double depth, double speed) {
  constexpr double kShare = 0.125, kGrowth = 1.25;
  const double rate = std::abs(point.rate) + speed;
  const bool holds = !point.clipped && depth <= kShare / std::max(1.0, c.exponent) * point.depth &&
                     c.dissipation * rate < 1;
  const double elastic = c.stiffness * oddPower(point.depth, c.exponent);
  if (!holds) return 2 * elastic + 1;
  const double slope = c.exponent * elastic / point.depth;
  return kGrowth * (slope * depth + elastic * c.dissipation * rate);
}

/// Whether a bristle goes on sticking while its end moves by at most `place` at a velocity that
/// changes by at most `speed`.
template <class V>
bool sticks(const Bristle& bristle, const V& s, const V& v, double place, double speed,
            double cap) {
  const double most = bristle.stiffness * (s.norm() + place) + bristle.damping * (v.norm() + speed);
  return most < cap;
}

}  // namespace

bool Patch::holdsStill(const Pose& pose, const double* own, const Stray& stray) const {
  const Now at = now(pose, own);
  const double arm = feature_.reach();
  const double place = stray.placeAt(arm), speed = stray.speedAt(arm);
  double loss = 0;
  for (std::size_t j = 0; j < at.count; ++j) {
    const bool touching = (at.mode & (kTouches << j)) != 0;
    if (touching ? !(at.point[j].depth > place) : !(-at.point[j].depth > place)) return false;
    if (touching) loss += lossOf(at.point[j], c_, place, speed);
  }
  if (!touches(at.mode)) return true;
  const double normal = at.normal - loss;
  if (!(normal > 0) || (at.mode & (kSlips | kRolls)) != 0) return false;
  const auto pair = [own](Own first) { return Eigen::Vector2d(own[first], own[first + 1]); };
  if (bristle_.exists() &&
      !sticks(bristle_, pair(kSlideStretch), at.v, place, speed, c_.friction * normal))
    return false;
  if (spins() && !holdsSpin(at, own, stray, loss)) return false;
  return !rolling_.exists() || sticks(rolling_, pair(kRollStretch), at.roll, stray.turn, stray.spin,
                                      c_.rolling_friction * normal);
}

/// About the normal.
bool Patch::holdsSpin(const Now& at, const double* own, const Stray& stray, double loss) const {
  if (at.mode & kSpins) {
    // one point alone, without friction about the normal; what its bristle holds has died away
    constexpr double kNothing = 1e-12;
    return at.spread == 0 && spinning_.stiffness * std::abs(own[kSpinStretch]) <=
                                 kNothing * c_.friction * at.normal * feature_.radius;
  }
  // the centre of pressure moves by at most 2 R loss/N
  const double spread = at.spread - 4 * feature_.radius * loss;
  return sticks(spinning_, Vector1d(own[kSpinStretch]), Vector1d(at.spin), stray.turn, stray.spin,
                c_.friction * spread);
}

bool PlaneContact::holdsStill(const Bodies& at, const std::vector<Stray>& strays) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    if (!patch.holdsStill(pose, own, strays[body_])) return false;
    own += Patch::kOwnCount;
  }
  return true;
}

bool BallContact::holdsStill(const Bodies& at, const std::vector<Stray>& strays) const {
  const auto strayOf = [&](const Side& side) {
    return side.body == kWorld ? Stray() : strays[side.body];
  };
  const Stray of_a = strayOf(a_), of_b = strayOf(b_);
  bool holds = true;
  forPairs(at, at.own, [&](std::size_t pair, const Now& now, const double* own) {
    const Feature& ball_a = a_.balls[pair / b_.balls.size()];
    const Feature& ball_b = b_.balls[pair % b_.balls.size()];
    if (!(now.mode & kTouches)) {
      holds = holds && -now.point.depth > of_a.placeAt(ball_a.center_P.norm()) +
                                              of_b.placeAt(ball_b.center_P.norm());
      return;
    }
    const double place = of_a.placeAt(ball_a.reach()) + of_b.placeAt(ball_b.reach());
    const double speed = of_a.speedAt(ball_a.reach()) + of_b.speedAt(ball_b.reach());
    const double normal = now.point.force(c_) - lossOf(now.point, c_, place, speed);
    holds = holds && now.point.depth > place && normal > 0 && !(now.mode & kSlips) &&
            (!bristle_.exists() || sticks(bristle_, Vector3d(own[1], own[2], own[3]), now.slip_W,
                                          place, speed, c_.friction * normal));
  });
  return holds;
}

}  // namespace rigid_body_sim
