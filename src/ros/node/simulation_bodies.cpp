#include "ros/node/simulation_node.hpp"

/// What follows the bodies of the world as they change.
namespace rigid_body_sim {

/// An input may have changed mass properties, and which bodies are present.
void SimulationNode::followBodies() {
  if (simulation_.worldChanges() == followed_changes_) return;
  followed_changes_ = simulation_.worldChanges();
  interfaces_.followBodies();
  outputs_.followBodies();
  for (const Body& body : simulation_.world().bodies) handles_.show(body.name, !body.absent);
}

}  // namespace rigid_body_sim
