#include "dynamics/contact/ball_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "dynamics/contact/flight_bound.hpp"
#include "dynamics/contact/swings.hpp"

namespace rigid_body_sim {
namespace {

Vector3d stretchOf(const double* own) { return {own[1], own[2], own[3]}; }

}  // namespace

BallContact::BallContact(Side a, Side b, const ContactParameters& parameters, double mass)
    : a_(std::move(a)),
      b_(std::move(b)),
      c_(parameters),
      mass_(mass),
      bristle_(Bristles::sliding(parameters, mass)) {}

std::vector<std::size_t> BallContact::members() const {
  if (b_.body == kWorld) return {a_.body};
  return {a_.body, b_.body};
}

std::shared_ptr<const ForceLaw> BallContact::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto copy = std::make_shared<BallContact>(*this);
  copy->a_.body = index(a_.body);
  if (b_.body != kWorld) copy->b_.body = index(b_.body);
  return copy;
}

/// Bristles are as stiff as for the masses with which the law was made, as those of PlaneContact.
std::shared_ptr<const ForceLaw> BallContact::reframed(std::size_t body, const Body& before,
                                                      const Body& after) const {
  const Isometry3d X_NP = frameBefore(before, after);
  auto copy = std::make_shared<BallContact>(*this);
  for (Side* side : {&copy->a_, &copy->b_})
    if (side->body == body)
      for (Feature& ball : side->balls) ball = moved(ball, X_NP);
  return copy;
}

BallContact::Frame BallContact::frameOf(const Side& side, const Bodies& at) {
  if (side.body == kWorld) return {};
  const Body& body = *at.bodies[side.body];
  const BodyState& s = at.states[side.body];
  return {s.x_W, s.x_low_W, s.p_W / body.mass, rotate(s.q_WP, angularVelocity(body.inv_I, s.L_P)),
          s.q_WP};
}

BallContact::Now BallContact::now(std::size_t pair, const Frame& a, const Frame& b,
                                  unsigned mode) const {
  const Feature& ball_a = a_.balls[pair / b_.balls.size()];
  const Feature& ball_b = b_.balls[pair % b_.balls.size()];
  const Vector3d r_a = rotate(a.q_WP, ball_a.center_P), r_b = rotate(b.q_WP, ball_b.center_P);
  const Vector3d apart = (a.x_W - b.x_W) + (a.low_W - b.low_W) + (r_a - r_b);
  Now now;
  now.mode = mode;
  now.distance = apart.norm();
  now.n_W = now.distance > 0 ? Vector3d(apart / now.distance) : Vector3d(Vector3d::UnitZ());
  now.point.depth = ball_a.radius + ball_b.radius - now.distance;
  now.point.clipped = (mode & kClips) != 0;
  // one point for both: then no angular momentum arises
  now.arm_a_W = r_a - (ball_a.radius - 0.5 * now.point.depth) * now.n_W;
  now.arm_b_W = r_b + (ball_b.radius - 0.5 * now.point.depth) * now.n_W;
  const Vector3d u = (a.v_W - b.v_W) + (a.w_W.cross(now.arm_a_W) - b.w_W.cross(now.arm_b_W));
  now.point.rate = -now.n_W.dot(u);
  now.slip_W = u + now.point.rate * now.n_W;
  const Vector3d of_centers = (a.v_W - b.v_W) + (a.w_W.cross(r_a) - b.w_W.cross(r_b));
  const Vector3d n_dot = (of_centers + now.point.rate * now.n_W) / std::max(now.distance, 1e-300);
  now.turn_W = now.n_W.cross(n_dot) + 0.5 * now.n_W.dot(a.w_W + b.w_W) * now.n_W;
  return now;
}

BallContact::Pull BallContact::pull(const Now& now, const double* own) const {
  return {bristle_, stretchOf(own), now.slip_W, c_.friction * now.point.force(c_),
          (now.mode & kSlips) != 0};
}

Vector3d BallContact::forceOnA(const Now& now, const double* own) const {
  const Vector3d normal_W = now.point.force(c_) * now.n_W;
  return bristle_.exists() ? Vector3d(normal_W + pull(now, own).pull) : normal_W;
}

void BallContact::addForceOnA(const Now& now, const Vector3d& f_W,
                              std::vector<Wrench>& wrenches) const {
  wrenches[a_.body].f_W += f_W;
  wrenches[a_.body].tau_W += now.arm_a_W.cross(f_W);
  if (b_.body == kWorld) return;
  wrenches[b_.body].f_W -= f_W;
  wrenches[b_.body].tau_W -= now.arm_b_W.cross(f_W);
}

void BallContact::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double* own) {
    addForceOnA(now, forceOnA(now, own), wrenches);
  });
}

void BallContact::addWrenchesAndRates(const Bodies& at, std::vector<Wrench>& wrenches,
                                      double* rates) const {
  std::fill_n(rates, stateCount(), 0.0);
  forTouching(at, at.own, [&](std::size_t pair, const Now& now, const double* own) {
    addForceOnA(now, forceOnA(now, own), wrenches);
    setRateOf(now, own, rates + pair * kOwnCount);
  });
}

double BallContact::potentialEnergy(const Bodies& at) const {
  double energy = 0;
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double* own) {
    energy += now.point.energy(c_) + 0.5 * bristle_.stiffness * stretchOf(own).squaredNorm();
  });
  return energy;
}

double BallContact::externalPower(const Bodies& at) const {
  double power = 0;
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double* own) {
    power += now.point.externalPower(c_);
    if (!bristle_.exists()) return;
    power += pull(now, own).power(bristle_, stretchOf(own), now.slip_W);
  });
  return power;
}

double BallContact::rate(const Bodies& at, const std::vector<double>& /*speeds*/) const {
  // what both sides' velocities move the point by adds up
  std::vector<Swings> swings;
  for (const Side* side : {&a_, &b_})
    if (side->body != kWorld)
      swings.emplace_back(*at.bodies[side->body], at.states[side->body].q_WP);
  double relaxing = 0;
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double*) {
    const Vector3d e1_W = now.n_W.unitOrthogonal(), e2_W = now.n_W.cross(e1_W);
    for (std::size_t side = 0; side < swings.size(); ++side) {
      const Vector3d& arm_W = side == 0 ? now.arm_a_W : now.arm_b_W;
      swings[side].addAt(arm_W, now.n_W, {now.point.stiffness(c_), now.point.damping(c_)});
      swings[side].addAt(arm_W, e1_W, bristle_);
      swings[side].addAt(arm_W, e2_W, bristle_);
    }
    if (now.mode & kSlips) relaxing = std::max(relaxing, bristle_.stiffness / bristle_.damping);
  });
  double frequency_squared = 0, decay = 0, slackness = 0;
  for (const Swings& of_side : swings) {
    frequency_squared += of_side.frequencySquared();
    decay += of_side.decay();
    slackness = std::max(slackness, of_side.slackness());
  }
  return std::max(relaxing, Swings::fastest(frequency_squared, decay, slackness));
}

double BallContact::touchRadius(std::size_t k) const {
  if (b_.body == kWorld) return std::numeric_limits<double>::infinity();
  double radius = 0;
  for (const Feature& ball : (k == 0 ? a_ : b_).balls) radius = std::max(radius, ball.reach());
  return radius;
}

double BallContact::reach(const Bodies& at) const {
  double length = 0;
  forPairs(at, at.own, [&](std::size_t, const Now& now, const double*) {
    length = std::max(length, now.distance + now.arm_a_W.norm() + now.arm_b_W.norm());
  });
  return length;
}

void BallContact::setRateOf(const Now& now, const double* own, double* rates) const {
  if (!bristle_.exists()) return;
  const Vector3d rate = pull(now, own).rate + now.turn_W.cross(stretchOf(own));
  std::copy_n(rate.data(), 3, rates + kStretch);
}

bool BallContact::admits(const double* own) const {
  for (std::size_t pair = 0; pair < pairCount(); ++pair)
    if (!isSumOfBits(own[pair * kOwnCount + kMode], 2 * kSlips - 1)) return false;
  return true;
}

void BallContact::setRates(const Bodies& at, double* rates) const {
  std::fill_n(rates, stateCount(), 0.0);
  forTouching(at, at.own, [&](std::size_t pair, const Now& now, const double* own) {
    setRateOf(now, own, rates + pair * kOwnCount);
  });
}

void BallContact::setGuards(const Bodies& at, double* guards) const {
  const Frame a = frameOf(a_, at), b = frameOf(b_, at);
  const double* own = at.own;
  for (std::size_t pair = 0; pair < pairCount(); ++pair, own += kOwnCount, guards += kGuardCount) {
    const Now now = this->now(pair, a, b, modeOf(own));
    const bool touches = (now.mode & kTouches) != 0;
    const double arm_a = now.arm_a_W.norm(), arm_b = now.arm_b_W.norm();
    guards[kTouch] =
        now.point.touchGuard(touches, kDepthRounding * (now.distance + arm_a + arm_b), [&] {
          return kDepthRounding *
                 (a.v_W.norm() + b.v_W.norm() + arm_a * a.w_W.norm() + arm_b * b.w_W.norm());
        });
    guards[kPull] = now.point.pushGuard(c_, touches);
    guards[kSlip] = 1;
    if (!touches || !bristle_.exists()) continue;
    const double excess =
        Pull::excess(bristle_, stretchOf(own), now.slip_W, c_.friction * now.point.force(c_));
    guards[kSlip] = (now.mode & kSlips) ? excess : Bristles::margin(mass_) - excess;
  }
}

void BallContact::switchMode(std::size_t guard, const Bodies& /*at*/, double* own) const {
  own += guard / kGuardCount * kOwnCount;
  const unsigned mode = modeOf(own);
  if (guard % kGuardCount == kTouch) {
    std::fill_n(own, static_cast<std::size_t>(kOwnCount), 0.0);
    own[kMode] = (mode & kTouches) ? 0U : 0U + kTouches;
  } else {
    own[kMode] = mode ^ (guard % kGuardCount == kPull ? kClips : kSlips);
  }
}

bool BallContact::acts(const double* own) const {
  for (std::size_t pair = 0; pair < pairCount(); ++pair)
    if (modeOf(own + pair * kOwnCount) & kTouches) return true;
  return false;
}

double BallContact::longestStep(const Bodies& at, double precision) const {
  double longest = std::numeric_limits<double>::infinity();
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double*) {
    longest = std::min(longest, now.point.longestStep(c_, mass_, precision));
  });
  return longest;
}

// With n as it is now, l(τ) >= n · (c_a − c_b)(τ), and the centres leave their tangents by at most
// ½ B τ².
double BallContact::quietInFlight(double t, const Bodies& at,
                                  const std::vector<MotionBound>& bounds) const {
  MotionBound fixed;
  fixed.until = std::numeric_limits<double>::infinity();
  const MotionBound& of_a = bounds[a_.body];
  const MotionBound& of_b = b_.body == kWorld ? fixed : bounds[b_.body];
  const auto turning = [&](const Side& side, const MotionBound& bound) {
    return side.body == kWorld ? 0
                               : turningBound(*at.bodies[side.body], at.states[side.body],
                                              bound.torque, kTurningTime);
  };
  const double turn_a = turning(a_, of_a), turn_b = turning(b_, of_b);
  const double push = (of_a.a_W - of_b.a_W).norm() + of_a.a_off + of_b.a_off;
  double quiet = std::min(of_a.until, of_b.until);
  if (of_a.torque > 0 || of_b.torque > 0) quiet = std::min(quiet, t + kTurningTime);
  forPairs(at, at.own, [&](std::size_t pair, const Now& now, const double*) {
    const double bend = push + turn_a * a_.balls[pair / b_.balls.size()].center_P.norm() +
                        turn_b * b_.balls[pair % b_.balls.size()].center_P.norm();
    const double clear = firstRoot(-now.point.depth, -now.point.rate, -bend);
    quiet = std::min(quiet, t + clear);
  });
  return quiet;
}

void BallContact::addContacts(const Bodies& at, std::vector<ContactPoint>& contacts) const {
  const Frame a = frameOf(a_, at);
  forTouching(at, at.own, [&](std::size_t, const Now& now, const double* own) {
    ContactPoint contact;
    contact.body = a_.label;
    contact.other = b_.label;
    contact.position_W = a.x_W + (a.low_W + now.arm_a_W);
    contact.normal_force_W = now.point.force(c_) * now.n_W;
    contact.friction_force_W = forceOnA(now, own) - contact.normal_force_W;
    contact.penetration = now.point.depth;
    contact.slips = (now.mode & kSlips) != 0;
    contacts.push_back(contact);
  });
}

void BallContact::addContactEvents(const Bodies& at, const double* before,
                                   std::vector<ContactEvent>& events) const {
  const Frame a = frameOf(a_, at);
  forPairs(at, at.own, [&](std::size_t pair, const Now& now, const double*) {
    const unsigned changed = modeOf(before + pair * kOwnCount) ^ now.mode;
    if (!(changed & kTouches)) return;
    const Vector3d place_W = a.x_W + (a.low_W + now.arm_a_W);
    events.push_back({0, a_.label, b_.label, (now.mode & kTouches) != 0, place_W});
  });
}

}  // namespace rigid_body_sim
