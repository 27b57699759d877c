#include "dynamics/contact/buried.hpp"

#include <stdexcept>

#include "dynamics/contact/plane_contact.hpp"
#include "dynamics/world_changes.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

void requireAbove(const World& world, const PlaneContact& contact, const BodyState& state) {
  const double depth = contact.buriedBy(state);
  if (!(depth > 0)) return;
  const std::size_t plane = contact.planeBody();
  throw std::invalid_argument("body '" + world.bodies[contact.members().front()].name +
                              "': it lies wholly below the plane" +
                              (plane == kWorld ? "" : " of '" + world.bodies[plane].name + "'") +
                              ", its top by " + shortest(depth) +
                              " m: planes are solid all the way down, put it above or on it");
}

}  // namespace

void requireNotBuried(const World& world, std::size_t body, const BodyState& state) {
  for (const auto& law : world.laws) {
    const auto* contact = dynamic_cast<const PlaneContact*>(law.get());
    if (contact && contact->members().front() == body && !rests(*law, world))
      requireAbove(world, *contact, state);
  }
}

void requireNoneBuried(const World& world, const std::vector<BodyState>& states) {
  for (const auto& law : world.laws) {
    const auto* contact = dynamic_cast<const PlaneContact*>(law.get());
    if (contact && !rests(*law, world))
      requireAbove(world, *contact, states[contact->members().front()]);
  }
}

}  // namespace rigid_body_sim
