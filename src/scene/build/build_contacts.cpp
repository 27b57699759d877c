#include "scene/build/build_contacts.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/build/body_names.hpp"
#include "scene/build/contact_shape.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

[[noreturn]] void refuse(const std::string& rule) { throw std::invalid_argument(rule); }

std::string quoted(const std::string& name) { return "'" + name + "'"; }

bool isMadeOfBalls(const ContactShape& shape) {
  return shape.points.empty() && shape.ellipsoids.empty() && shape.rims.empty();
}

}  // namespace

ContactBuilder::ContactBuilder(const Scene& scene, const std::vector<Body>& bodies,
                               const FrameTable& frames)
    : scene_(scene), bodies_(bodies), frames_(frames), shapes_(bodies.size()) {
  for (std::size_t i = 0; i < bodies.size(); ++i) index_.emplace(bodies[i].name, i);
  for (const ForceDef& force : scene.forces) {
    const auto* contact = std::get_if<ContactDef>(&force.law);
    if (!contact || index_.count(contact->body) == 0 || index_.count(contact->other) == 0) continue;
    named_.insert(std::minmax({index_.at(contact->body), index_.at(contact->other)}));
  }
}

ForceLaws ContactBuilder::lawsOf(const ContactDef& def) {
  const std::size_t body = indexOf(def.body);
  ForceLaws laws;
  if (def.other.empty()) {
    addWithAll(body, def.parameters, laws);
    return laws;
  }
  const std::size_t other = indexOf(def.other);
  if (!claim(std::minmax({body, other})))
    refuse("between names a pair that an entry before it names, " + quoted(def.body) + " and " +
           quoted(def.other));
  laws.push_back(lawBetween(body, other, def.parameters));
  return laws;
}

std::size_t ContactBuilder::indexOf(const std::string& name) const {
  const auto found = index_.find(name);
  if (found != index_.end()) return found->second;
  refuse("between: unknown body '" + printable(name) + "' (known: " + nameList(namesOf(bodies_)) +
         ")" + didYouMean(name, namesOf(bodies_)));
}

/// Whether the pair has no law yet; from now on it has one.
bool ContactBuilder::claim(const Pair& pair) {
  const bool is_new = made_.insert(pair).second;
  if (made_.size() > kMaxContactPairs)
    refuse("the contacts of a scene must be between at most " + std::to_string(kMaxContactPairs) +
           " pairs of bodies");
  return is_new;
}

void ContactBuilder::addWithAll(std::size_t body, const ContactParameters& parameters,
                                ForceLaws& laws) {
  if (index_.count("all") > 0)
    refuse("between: 'all' means every other body here, so that no body may be named all");
  if (!with_all_.insert(body).second)
    refuse("between: an entry before it names " + quoted(bodies_[body].name) + " and all");
  requireNoPivot(body, "leave it out of between");
  bool alone = true;
  for (std::size_t other = 0; other < bodies_.size(); ++other) {
    if (other == body || (bodies_[body].fixed && bodies_[other].fixed) || !touches(other)) continue;
    alone = false;
    const Pair pair = std::minmax({body, other});
    if (named_.count(pair) > 0 || !claim(pair)) continue;
    requireNoPivot(other, "take it from what all means, by collision: []");
    ContactParameters of_pair = parameters;
    if (!isPlane(body) && !isPlane(other)) of_pair.rolling_friction = 0;
    laws.push_back(lawBetween(body, other, of_pair));
  }
  if (alone)
    refuse("between: there is no other body that has a shape for " + quoted(bodies_[body].name) +
           " to touch");
}

std::shared_ptr<const ForceLaw> ContactBuilder::lawBetween(std::size_t a, std::size_t b,
                                                           const ContactParameters& parameters) {
  if (bodies_[a].fixed) std::swap(a, b);
  const std::string& name_a = bodies_[a].name;
  const std::string& name_b = bodies_[b].name;
  if (bodies_[a].fixed)
    refuse("between must name a body that moves, but " + quoted(name_a) + " and " + quoted(name_b) +
           " are fixed");
  for (const std::size_t body : {a, b})
    if (!touches(body))
      refuse("between: body " + quoted(bodies_[body].name) +
             " has no shape to touch by; give it one: collision: [{shape: ...}, ...]");
  for (const std::size_t body : {a, b}) requireNoPivot(body, "leave it out of between");
  if (isPlane(b)) return lawOnPlane(a, b, parameters);
  if (!isMadeOfBalls(shapeOf(a)) || !isMadeOfBalls(shapeOf(b)))
    refuse(
        "between must be a body and a plane, or two bodies made of balls (sphere, capsule, as "
        "shape, parts or collision), got " +
        quoted(name_a) + " and " + quoted(name_b));
  if (parameters.rolling_friction > 0)
    refuse("rolling_friction acts on planes only, but neither " + quoted(name_a) + " nor " +
           quoted(name_b) + " is one");
  return contactOfBalls(bodies_, a, shapeOf(a), b, shapeOf(b), parameters);
}

/// else_do: instead of removing it.
void ContactBuilder::requireNoPivot(std::size_t body, const std::string& else_do) const {
  if (bodies_[body].pivoted)
    refuse("between: body " + quoted(bodies_[body].name) +
           " is on a pivot, and contact of such a body is not supported; remove its pivot or " +
           else_do);
}

std::shared_ptr<const ForceLaw> ContactBuilder::lawOnPlane(std::size_t body, std::size_t plane,
                                                           const ContactParameters& parameters) {
  const BodyDef& def = scene_.bodies[plane];
  return contactWithHalfSpace(bodies_, body, shapeOf(body), {plane, def.position, def.orientation},
                              parameters);
}

bool ContactBuilder::isPlane(std::size_t body) const {
  return std::holds_alternative<PlaneDef>(scene_.bodies[body].composition);
}

const ContactShape& ContactBuilder::shapeOf(std::size_t body) {
  if (!shapes_[body])
    shapes_[body] = contactShapeOf(scene_.bodies[body], frames_.find(bodies_[body].name)->X_PF);
  return *shapes_[body];
}

}  // namespace rigid_body_sim
