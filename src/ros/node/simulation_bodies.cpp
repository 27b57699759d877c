#include "ros/node/simulation_node.hpp"

/// What follows the bodies of the world as they change.
namespace rigid_body_sim {

/// An input may have changed mass properties, and which bodies are present.
void SimulationNode::followBodies() {
  const World* world = &simulation_.world();
  if (world == followed_world_) return;  // where bodies have changed, it is another
  followed_world_ = world;
  wrenches_.followBodies();
  outputs_.followBodies();
  for (const Body& body : simulation_.world().bodies) handles_.show(body.name, !body.absent);
}

}  // namespace rigid_body_sim
