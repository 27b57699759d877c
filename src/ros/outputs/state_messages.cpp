#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {

BodyStates emptyBodyStates(const World& world, const std::vector<std::size_t>& bodies,
                           const std::string& world_frame) {
  BodyStates message;
  message.header.frame_id = world_frame;
  for (const std::size_t body : bodies) message.name.push_back(world.bodies[body].name);
  message.pose.resize(bodies.size());
  message.twist.resize(bodies.size());
  return message;
}

void setBodyStates(const World& world, const std::vector<std::size_t>& bodies,
                   const std::vector<BodyState>& states, const ros::Time& stamp,
                   BodyStates& message) {
  message.header.stamp = stamp;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = world.bodies[bodies[i]];
    const BodyState& state = states[bodies[i]];
    message.pose[i] = toPose(toBodyFrameMotion(body, state));
    message.twist[i] = toTwistInBodyAxes(body, state);
  }
}

geometry_msgs::WrenchStamped toWrenchStamped(const Body& body, const BodyState& state,
                                             const Wrench& wrench, const ros::Time& stamp) {
  const Vector3d f_P = rotateBack(state.q_WP, wrench.f_W);
  Vector3d tau_P = rotateBack(state.q_WP, wrench.tau_W) + wrench.tau_P;
  if (body.pivoted) tau_P -= body.com_P.cross(f_P);  // from the pivot to the centre of mass
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = body.name;
  message.wrench.force = toVector3(rotate(body.q_BP, f_P));
  message.wrench.torque = toVector3(rotate(body.q_BP, tau_P));
  return message;
}

geometry_msgs::AccelStamped toAccelStamped(const Body& body, const BodyMotion& motion,
                                           const ros::Time& stamp) {
  const Vector3d origin_P = body.X_BP.inverse().translation();
  const Vector3d a_P = rotateBack(motion.state.q_WP, accelerationOf(body, motion, origin_P));
  geometry_msgs::AccelStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = body.name;
  message.accel.linear = toVector3(rotate(body.q_BP, a_P));
  message.accel.angular = toVector3(rotate(body.q_BP, motion.acceleration.w_dot_P));
  return message;
}

geometry_msgs::WrenchStamped toPivotForce(const Body& body, const BodyMotion& motion,
                                          const ros::Time& stamp) {
  const Vector3d f_P = rotateBack(motion.state.q_WP, pivotForceOf(body, motion));
  geometry_msgs::WrenchStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = body.name;
  message.wrench.force = toVector3(rotate(body.q_BP, f_P));
  return message;
}

sensor_msgs::JointState toJointState(const Body& body, const std::vector<ActuatorReading>& readings,
                                     const ros::Time& stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.header.frame_id = body.name;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const Actuator& actuator = body.actuators[i];
    const bool is_wheel = std::holds_alternative<Wheel>(actuator.kind);
    message.name.push_back(actuator.name);
    message.velocity.push_back(readings[i].speed);
    message.effort.push_back(is_wheel ? readings[i].torque : readings[i].force);
  }
  return message;
}

}  // namespace rigid_body_sim
