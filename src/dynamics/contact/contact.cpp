#include <algorithm>
#include <stdexcept>
#include <string>

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/contact/ball_contact.hpp"
#include "dynamics/contact/plane_contact.hpp"
#include "dynamics/state_of_world.hpp"

namespace rigid_body_sim {
namespace {

void requireThatMoves(const std::vector<Body>& bodies, std::size_t body) {
  if (body >= bodies.size())
    throw std::invalid_argument("contact: no body has the index " + std::to_string(body));
  if (bodies[body].fixed)
    throw std::invalid_argument("contact of body '" + bodies[body].name +
                                "': it is fixed, no law can move it");
}

}  // namespace

std::shared_ptr<const ForceLaw> contactWithHalfSpace(const std::vector<Body>& bodies,
                                                     std::size_t body, const ContactShape& shape,
                                                     const HalfSpace& plane,
                                                     const ContactParameters& parameters) {
  checkParameters(parameters);
  requireThatMoves(bodies, body);
  const std::string name = "contact of body '" + bodies[body].name + "': ";
  if (shape.empty()) throw std::invalid_argument(name + "it has no shape that could touch");
  if (!plane.origin_W.allFinite() || !isNearlyUnit(plane.q_WH))
    throw std::invalid_argument(name + "the plane's origin must be finite, its attitude unit");
  if (plane.body != kWorld && (plane.body >= bodies.size() || !bodies[plane.body].fixed))
    throw std::invalid_argument(name +
                                "the plane must be of a fixed body or of the world, got index " +
                                std::to_string(plane.body));
  return std::make_shared<PlaneContact>(bodies[body], body, featuresOf(shape, bodies[body].name),
                                        plane, parameters);
}

std::shared_ptr<const ForceLaw> contactOfBalls(const std::vector<Body>& bodies, std::size_t a,
                                               const ContactShape& shape_a, std::size_t b,
                                               const ContactShape& shape_b,
                                               const ContactParameters& parameters) {
  checkParameters(parameters);
  requireThatMoves(bodies, a);
  if (b >= bodies.size() || a == b)
    throw std::invalid_argument("contact: it takes two bodies, got the indices " +
                                std::to_string(a) + " and " + std::to_string(b));
  const auto side = [&](std::size_t body, const ContactShape& shape) {
    if (shape.balls.empty() || !shape.points.empty() || !shape.ellipsoids.empty() ||
        !shape.rims.empty())
      throw std::invalid_argument("contact of body '" + bodies[body].name +
                                  "': between bodies, only balls touch");
    return BallContact::Side{bodies[body].fixed ? kWorld : body, body,
                             featuresOf(shape, bodies[body].name)};
  };
  const double m_a = bodies[a].mass, m_b = bodies[b].mass;
  const double mass = bodies[b].fixed ? m_a : m_a * m_b / (m_a + m_b);
  return std::make_shared<BallContact>(side(a, shape_a), side(b, shape_b), parameters, mass);
}

bool hasContact(const World& world) {
  return std::any_of(world.laws.begin(), world.laws.end(),
                     [](const auto& law) { return (law->needs() & kContact) != 0; });
}

bool hasOneSidedLaw(const World& world) {
  return std::any_of(world.laws.begin(), world.laws.end(),
                     [](const auto& law) { return law->isOneSided(); });
}

std::vector<ContactPoint> contactsOf(const World& world, const State& state) {
  std::vector<ContactPoint> contacts;
  requireStateOf(world, state);
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
