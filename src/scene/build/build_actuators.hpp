#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Thrusters, rotors, wheels, each kind in the order of the scene.
std::vector<Actuator> actuatorsOf(const ActuatorDefs& defs);

/// Index of the actuator of that name. Throws std::invalid_argument, one line, for an unknown one.
std::size_t actuatorNamed(const std::string& name, const Body& body);

/// The commands that a scene schedules. Throws SceneError for one to an unknown actuator.
std::vector<ActuatorCommand> commandsOf(const Scene& scene, const std::vector<Body>& bodies);

}  // namespace rigid_body_sim
