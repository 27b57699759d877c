#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {

BodyStates emptyBodyStates(const World& world, const std::string& world_frame) {
  BodyStates message;
  message.header.frame_id = world_frame;
  for (const Body& body : world.bodies) message.name.push_back(body.name);
  message.pose.resize(world.bodies.size());
  message.twist.resize(world.bodies.size());
  return message;
}

void setBodyStates(const World& world, const std::vector<BodyState>& states, const ros::Time& stamp,
                   BodyStates& message) {
  message.header.stamp = stamp;
  for (std::size_t i = 0; i < states.size(); ++i) {
    message.pose[i] = toPose(toBodyFrameMotion(world.bodies[i], states[i]));
    message.twist[i] = toTwistInBodyAxes(world.bodies[i], states[i]);
  }
}

BodyStates toBodyStates(const World& world, const State& state, const std::string& world_frame,
                        const ros::Time& stamp) {
  BodyStates message = emptyBodyStates(world, world_frame);
  setBodyStates(world, state.bodies, stamp, message);
  return message;
}

geometry_msgs::WrenchStamped toWrenchStamped(const Body& body, const BodyState& state,
                                             const Wrench& wrench, const ros::Time& stamp) {
  const Vector3d f_P = rotateBack(state.q_WP, wrench.f_W);
  const Vector3d tau_P = rotateBack(state.q_WP, wrench.tau_W) + wrench.tau_P;
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = body.name;
  message.wrench.force = toVector3(rotate(body.q_BP, f_P));
  message.wrench.torque = toVector3(rotate(body.q_BP, tau_P));
  return message;
}

}  // namespace rigid_body_sim
