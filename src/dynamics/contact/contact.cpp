#include <stdexcept>

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/contact/plane_contact.hpp"

namespace rigid_body_sim {

std::shared_ptr<const ForceLaw> contactWithHalfSpace(const std::vector<Body>& bodies,
                                                     std::size_t body, const ContactShape& shape,
                                                     const HalfSpace& plane,
                                                     const ContactParameters& parameters) {
  checkParameters(parameters);
  if (body >= bodies.size())
    throw std::invalid_argument("contact: no body has the index " + std::to_string(body));
  const std::string name = "contact of body '" + bodies[body].name + "': ";
  if (bodies[body].fixed) throw std::invalid_argument(name + "it is fixed, no law can move it");
  if (shape.empty()) throw std::invalid_argument(name + "it has no shape that could touch");
  if (!plane.origin_W.allFinite() || !isNearlyUnit(plane.q_WH))
    throw std::invalid_argument(name + "the plane's origin must be finite, its attitude unit");
  return std::make_shared<PlaneContact>(bodies[body], body, featuresOf(shape, bodies[body].name),
                                        plane, parameters);
}

std::vector<ContactPoint> contactsOf(const World& world, const State& state) {
  std::vector<ContactPoint> contacts;
  if (state.laws.empty()) return contacts;
  std::vector<const Body*> bodies;
  for (const Body& body : world.bodies) bodies.push_back(&body);
  const double* own = state.laws.data();
  for (const auto& law : world.laws) {
    law->addContacts({bodies, state.bodies, own}, contacts);
    own += law->stateCount();
  }
  return contacts;
}

}  // namespace rigid_body_sim
