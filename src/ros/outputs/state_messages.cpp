#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {

BodyStates toBodyStates(const World& world, const State& state, const std::string& world_frame,
                        const ros::Time& stamp) {
  BodyStates message;
  message.header.stamp = stamp;
  message.header.frame_id = world_frame;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    message.name.push_back(body.name);
    message.pose.push_back(toPose(toBodyFrameMotion(body, state.bodies[i])));
    message.twist.push_back(toTwistInBodyAxes(body, state.bodies[i]));
  }
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
