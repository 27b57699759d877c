#include "dynamics/contact/buried.hpp"

#include <stdexcept>

#include "dynamics/contact/plane_contact.hpp"
#include "dynamics/world_changes.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

/// Empty where some of the body may reach out of the plane, or the law is no contact with one.
std::string faultOf(const World& world, const PlaneContact& contact, const BodyState& state) {
  const double depth = contact.buriedBy(state);
  if (!(depth > 0)) return "";
  const std::size_t plane = contact.planeBody();
  return "body '" + world.bodies[contact.members().front()].name +
         "': position must leave some of it above the plane" +
         (plane == kWorld ? "" : " of '" + world.bodies[plane].name + "'") + ", got its top " +
         shortest(depth) + " m below: planes are solid all the way down, put it above or on it";
}

}  // namespace

std::optional<BuriedBody> findBuried(const World& world, const std::vector<BodyState>& states) {
  for (const auto& law : world.laws) {
    const auto* contact = dynamic_cast<const PlaneContact*>(law.get());
    if (!contact || rests(*law, world)) continue;
    const std::size_t body = contact->members().front();
    const std::string fault = faultOf(world, *contact, states[body]);
    if (!fault.empty()) return BuriedBody{body, fault};
  }
  return std::nullopt;
}

void requireNoneBuried(const World& world, const std::vector<BodyState>& states) {
  if (const auto buried = findBuried(world, states)) throw std::invalid_argument(buried->fault);
}

void requireNotBuried(const World& world, std::size_t body, const BodyState& state) {
  for (const auto& law : world.laws) {
    const auto* contact = dynamic_cast<const PlaneContact*>(law.get());
    if (!contact || contact->members().front() != body || rests(*law, world)) continue;
    const std::string fault = faultOf(world, *contact, state);
    if (!fault.empty()) throw std::invalid_argument(fault);
  }
}

}  // namespace rigid_body_sim
