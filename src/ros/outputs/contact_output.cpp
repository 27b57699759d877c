#include "ros/outputs/contact_output.hpp"

#include <utility>

namespace rigid_body_sim {
namespace {

std::string nameOf(std::size_t body, const World& world) {
  return body == kWorld ? std::string() : world.bodies[body].name;
}

ContactState toMessage(const ContactPoint& contact, const World& world) {
  ContactState message;
  message.body = nameOf(contact.body, world);
  message.other = nameOf(contact.other, world);
  message.position = toPoint(contact.position_W);
  message.normal_force = toVector3(contact.normal_force_W);
  message.friction_force = toVector3(contact.friction_force_W);
  message.penetration = contact.penetration;
  message.slips = contact.slips;
  return message;
}

ContactChange toMessage(const ContactEvent& event, const World& world, const TimeOrigin& origin) {
  ContactChange message;
  message.stamp = origin.stamp(event.t);
  message.time = event.t;
  message.body = nameOf(event.body, world);
  message.other = nameOf(event.other, world);
  message.touch = event.touch;
  message.position = toPoint(event.position_W);
  return message;
}

}  // namespace

ContactOutput::ContactOutput(Topic<Contacts> topic, std::string world_frame,
                             const TimeOrigin& origin)
    : topic_(std::move(topic)), world_frame_(std::move(world_frame)), origin_(origin) {}

void ContactOutput::keepChanges(const Simulation& simulation) {
  if (!hasSubscribers()) return changes_.clear();
  if (std::exchange(kept_steps_, simulation.steps()) == simulation.steps()) return;
  for (const ContactEvent& event : simulation.contactEvents())
    changes_.push_back(toMessage(event, simulation.world(), origin_));
}

void ContactOutput::publish(const Snapshot& snapshot, const ros::Time& stamp) {
  Contacts message = standing(snapshot, stamp);
  message.changes.swap(changes_);
  topic_.publish(message, stamp);
}

Contacts ContactOutput::standing(const Snapshot& snapshot, const ros::Time& stamp) const {
  Contacts message;
  message.header.frame_id = world_frame_;
  message.header.stamp = stamp;
  for (const ContactPoint& contact : snapshot.contacts())
    message.contacts.push_back(toMessage(contact, snapshot.world()));
  return message;
}

void ContactOutput::greetWith(Topic<Contacts>::Greeting greeting) {
  if (topic_.greetWith) topic_.greetWith(std::move(greeting));
}

void ContactOutput::restart() {
  changes_.clear();
  kept_steps_ = -1;
}

}  // namespace rigid_body_sim
