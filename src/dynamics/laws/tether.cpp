#include <algorithm>
#include <limits>

#include <rigid_body_sim/dynamics/tether.hpp>

#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/line.hpp"
#include "dynamics/laws/turning_bound.hpp"

namespace rigid_body_sim {
namespace {

/// [N] What spring and damper would exert in parallel; below zero where they would push.
double unclippedPull(const Tether::Constants& constants, const Line& line) {
  return constants.stiffness * (line.length - constants.length) + constants.damping * line.rate;
}

}  // namespace

Tether::Tether(const Spring::End& from, const Spring::End& to, const Constants& constants)
    : ends_{from, to}, constants_(constants) {
  checkEnds("tether", ends_);
  requirePositive("tether", "stiffness must be > 0 N/m", constants.stiffness);
  requireNotNegative("tether", "damping must be >= 0 N s/m", constants.damping);
  requirePositive("tether", "length must be > 0 m", constants.length);
}

std::vector<std::size_t> Tether::members() const { return membersOf(ends_); }

std::shared_ptr<const ForceLaw> Tether::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto copy = std::make_shared<Tether>(*this);
  copy->ends_ = reindexedEnds(ends_, index);
  return copy;
}

std::shared_ptr<const ForceLaw> Tether::reframed(std::size_t body, const Body& before,
                                                 const Body& after) const {
  auto copy = std::make_shared<Tether>(*this);
  copy->ends_ = reframedEnds(ends_, body, frameBefore(before, after));
  return copy;
}

// Within a step that an event will end, the pull may fall below zero while the mode is still taut:
// it is not cut off there, so that the integrator sees a smooth force.
void Tether::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  if (at.own[0] != kTaut) return;
  const Line line = lineBetween(ends_, at, constants_.damping > 0);
  addTension(ends_, line, unclippedPull(constants_, line), at, wrenches);
}

double Tether::tension(const Bodies& at) const {
  if (at.own[0] != kTaut) return 0;
  return std::max(0.0, unclippedPull(constants_, lineBetween(ends_, at, constants_.damping > 0)));
}

double Tether::potentialEnergy(const Bodies& at) const {
  const double extension = std::max(0.0, gapBetween(ends_, at).norm() - constants_.length);
  return 0.5 * constants_.stiffness * extension * extension;
}

double Tether::externalPower(const Bodies& at) const {
  if (at.own[0] == kSlack || constants_.damping == 0) return 0;
  const Line line = lineBetween(ends_, at, true);
  if (at.own[0] == kTaut) return -constants_.damping * line.rate * line.rate;
  return constants_.stiffness * (line.length - constants_.length) * line.rate;
}

void Tether::addStiffness(const std::vector<const Body*>& bodies,
                          std::vector<Stiffness>& stiffness) const {
  addStiffnessOf(ends_, constants_.stiffness, constants_.damping, bodies, stiffness);
}

double Tether::reach(const Bodies& at) const { return reachOf(ends_, at); }

void Tether::setGuards(const Bodies& at, double* guards) const {
  const Line line = lineBetween(ends_, at, constants_.damping > 0 && at.own[0] != kSlack);
  const double excess = line.length - constants_.length;
  guards[0] = at.own[0] == kSlack  ? -excess
              : at.own[0] == kTaut ? unclippedPull(constants_, line)
                                   : excess;
  guards[1] = at.own[0] == kLimp ? -unclippedPull(constants_, line) : 1;
}

void Tether::switchMode(std::size_t guard, const Bodies& /*at*/, double* own) const {
  if (own[0] == kTaut)
    own[0] = kLimp;
  else if (own[0] == kSlack || guard == 1)
    own[0] = kTaut;
  else
    own[0] = kSlack;
}

/// With d the gap between the ends and u its rate, l(τ) <= |d + u τ| + ½ bend τ², bend being a
/// bound on the second derivative of the gap: the right side is convex.
double Tether::quietInFlight(double t, const Bodies& at,
                             const std::vector<MotionBound>& bounds) const {
  double bend = 0, until = std::numeric_limits<double>::infinity();
  Vector3d a_W = Vector3d::Zero();
  for (std::size_t k = 0; k < 2; ++k) {
    const Spring::End& end = ends_[k];
    if (end.body == kWorld) continue;
    const MotionBound& bound = bounds[end.body];
    a_W += (k == 0 ? -1.0 : 1.0) * bound.a_W;
    bend += bound.a_off;
    until = std::min(until, bound.until);
    if (end.point.isZero(0)) continue;
    bend += end.point.norm() *
            turningBound(*at.bodies[end.body], at.states[end.body], bound.torque, kTurningTime);
    if (bound.torque > 0) until = std::min(until, t + kTurningTime);
  }
  bend += a_W.norm();
  const Vector3d d = gapBetween(ends_, at), u = velocityOf(ends_[1], at) - velocityOf(ends_[0], at);
  const auto room = [&](double tau) {
    return constants_.length - (d + tau * u).norm() - 0.5 * bend * tau * tau;
  };
  const double now = room(0);
  if (!(now >= 0) || !std::isfinite(bend)) return t;
  return std::min(t + lastRoot(room, firstGuess(now, u.norm(), bend)), until);
}

}  // namespace rigid_body_sim
