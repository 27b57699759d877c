#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/actuators/actuator_table.hpp"
#include "dynamics/state_of_world.hpp"

namespace rigid_body_sim {

namespace {

/// What wheels and rotors have beyond ½ ω·I ω [J].
double spinEnergy(const World& world, const State& given) {
  const State state = withActuators(world, given);
  double energy = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (!body.actuators.empty() && !body.absent)
      energy += energyOf(actuatorTable(body), state.actuators[i], state.t,
                         angularVelocity(body.inv_I, state.bodies[i].L_P));
  }
  return energy;
}

}  // namespace

double mechanicalEnergy(const World& world, const State& state) {
  requireStateOf(world, state);
  std::vector<const Body*> bodies;
  double energy = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    bodies.push_back(&body);
    if (!moves(body)) continue;
    energy += kineticEnergy(body, state.bodies[i]) -
              body.mass * world.g_W.dot(centerOfMass(body, state.bodies[i]));
  }
  std::vector<double> own = state.laws;
  const bool as_they_start = own.empty();
  std::size_t first = 0;
  for (const auto& law : world.laws) {
    if (as_they_start) {
      own.resize(first + law->stateCount());
      law->setStart(own.data() + first);
    }
    const ForceLaw::Bodies at{bodies, state.bodies, own.data() + first};
    if (law->acts(at.own)) energy += law->potentialEnergy(at);
    first += law->stateCount();
  }
  return hasActuators(world) ? energy + spinEnergy(world, state) : energy;
}

}  // namespace rigid_body_sim
