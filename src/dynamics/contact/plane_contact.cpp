#include "dynamics/contact/plane_contact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "dynamics/contact/flight_bound.hpp"

namespace rigid_body_sim {

PlaneContact::PlaneContact(const Body& on, std::size_t body, const std::vector<Feature>& features,
                           const HalfSpace& plane, const ContactParameters& parameters)
    : body_(body), label_(body), plane_(plane) {
  for (const Feature& feature : features) {
    patches_.emplace_back(feature, parameters, on.mass);
    guard_count_ += patches_.back().guardCount();
    reach_ = std::max(reach_, feature.reach());
  }
}

std::shared_ptr<const ForceLaw> PlaneContact::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto copy = std::make_shared<PlaneContact>(*this);
  copy->body_ = index(body_);
  return copy;
}

/// Bristles are as stiff as for the mass with which the law was made: a stretch in them keeps its
/// force.
std::shared_ptr<const ForceLaw> PlaneContact::reframed(std::size_t /*body*/, const Body& before,
                                                       const Body& after) const {
  const Isometry3d X_NP = frameBefore(before, after);
  auto copy = std::make_shared<PlaneContact>(*this);
  copy->reach_ = 0;
  for (Patch& patch : copy->patches_) {
    patch.setFeature(moved(patch.feature(), X_NP));
    copy->reach_ = std::max(copy->reach_, patch.feature().reach());
  }
  return copy;
}

void PlaneContact::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    patch.addWrench(pose, own, wrenches[body_]);
    own += Patch::kOwnCount;
  }
}

void PlaneContact::addWrenchesAndRates(const Bodies& at, std::vector<Wrench>& wrenches,
                                       double* rates) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    patch.addWrenchAndRates(pose, own, wrenches[body_], rates);
    own += Patch::kOwnCount;
    rates += Patch::kOwnCount;
  }
}

/// Σ term(patch, pose, its own states)
template <class Term>
double PlaneContact::sum(const Bodies& at, const Term& term) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  double total = 0;
  for (const Patch& patch : patches_) {
    total += term(patch, pose, own);
    own += Patch::kOwnCount;
  }
  return total;
}

double PlaneContact::potentialEnergy(const Bodies& at) const {
  return sum(at, std::mem_fn(&Patch::potentialEnergy));
}

double PlaneContact::externalPower(const Bodies& at) const {
  return sum(at, std::mem_fn(&Patch::externalPower));
}

double PlaneContact::rate(const Bodies& at, const std::vector<double>& /*speeds*/) const {
  const Patch::Pose pose = poseOf(at);
  Swings swings(pose.body, pose.state.q_WP);
  double relaxing = 0;
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    relaxing = std::max(relaxing, patch.addSwings(pose, own, swings));
    own += Patch::kOwnCount;
  }
  return std::max(relaxing,
                  Swings::fastest(swings.frequencySquared(), swings.decay(), swings.slackness()));
}

double PlaneContact::reach(const Bodies& at) const { return std::abs(poseOf(at).height) + reach_; }

double PlaneContact::buriedBy(const BodyState& state) const {
  return -plane_.n_W.dot(state.x_W + state.x_low_W - plane_.half_space.origin_W) - reach_;
}

bool PlaneContact::admits(const double* own) const {
  for (std::size_t k = 0; k < patches_.size(); ++k)
    if (!Patch::admits(own + k * Patch::kOwnCount)) return false;
  return true;
}

void PlaneContact::setRates(const Bodies& at, double* rates) const {
  const Patch::Pose pose = poseOf(at);
  for (std::size_t i = 0; i < patches_.size(); ++i)
    patches_[i].setRates(pose, at.own + i * Patch::kOwnCount, rates + i * Patch::kOwnCount);
}

void PlaneContact::setGuards(const Bodies& at, double* guards) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    patch.setGuards(pose, own, guards);
    guards += patch.guardCount();
    own += Patch::kOwnCount;
  }
}

void PlaneContact::switchMode(std::size_t guard, const Bodies& /*at*/, double* own) const {
  for (const Patch& patch : patches_) {
    if (guard < patch.guardCount()) return patch.switchMode(guard, own);
    guard -= patch.guardCount();
    own += Patch::kOwnCount;
  }
}

bool PlaneContact::acts(const double* own) const {
  for (std::size_t i = 0; i < patches_.size(); ++i)
    if (Patch::touches(Patch::modeOf(own + i * Patch::kOwnCount))) return true;
  return false;
}

double PlaneContact::longestStep(const Bodies& at, double precision) const {
  const Patch::Pose pose = poseOf(at);
  double longest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < patches_.size(); ++i)
    longest =
        std::min(longest, patches_[i].longestStep(pose, at.own + i * Patch::kOwnCount, precision));
  return longest;
}

double PlaneContact::quietInFlight(double t, const Bodies& at,
                                   const std::vector<MotionBound>& bounds) const {
  const MotionBound& bound = bounds[body_];
  const PlaneFlight flight(*at.bodies[body_], at.states[body_], plane_.half_space, bound);
  double quiet = flight.clearFor(reach_);
  if (!(quiet > 0)) {
    quiet = std::numeric_limits<double>::infinity();
    for (const Patch& patch : patches_) quiet = std::min(quiet, flight.clearFor(patch.feature()));
  }
  return std::min(t + quiet, bound.until);
}

ContactPoint PlaneContact::contactAt(const Patch::Pose& pose, const Patch& patch,
                                     const double* own) const {
  const Patch::Now now = patch.now(pose, own);
  ContactPoint contact;
  contact.body = label_;
  contact.other = plane_.half_space.body;
  contact.position_W = pose.state.x_W + (pose.state.x_low_W + now.center_W);
  contact.normal_force_W = now.normal * pose.n_W;
  contact.friction_force_W = patch.friction(pose, now, own);
  contact.penetration = now.point[0].depth;
  contact.slips = (now.mode & Patch::kSlips) != 0;
  return contact;
}

void PlaneContact::addContacts(const Bodies& at, std::vector<ContactPoint>& contacts) const {
  const Patch::Pose pose = poseOf(at);
  const double* own = at.own;
  for (const Patch& patch : patches_) {
    if (Patch::touches(Patch::modeOf(own))) contacts.push_back(contactAt(pose, patch, own));
    own += Patch::kOwnCount;
  }
}

void PlaneContact::addContactEvents(const Bodies& at, const double* before,
                                    std::vector<ContactEvent>& events) const {
  const Patch::Pose pose = poseOf(at);
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const double* own = at.own + i * Patch::kOwnCount;
    const bool touched = Patch::touches(Patch::modeOf(before + i * Patch::kOwnCount));
    const bool touches = Patch::touches(Patch::modeOf(own));
    if (touched == touches) continue;
    const Vector3d place_W = contactAt(pose, patches_[i], own).position_W;
    events.push_back({0, label_, plane_.half_space.body, touches, place_W});
  }
}

}  // namespace rigid_body_sim
