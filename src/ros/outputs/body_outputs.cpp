#include "ros/outputs/body_outputs.hpp"

#include <algorithm>
#include <utility>

namespace rigid_body_sim {

void BodyOutputs::add(BodyTopics topics) {
  greet(topics);
  asked_.clear();
  topics_.push_back(std::move(topics));
}

void BodyOutputs::remove(std::size_t body) {
  const auto is_body = [body](const auto& topics) { return topics.body == body; };
  asked_.clear();
  topics_.erase(std::remove_if(topics_.begin(), topics_.end(), is_body), topics_.end());
}

/// Who comes while time stands is sent the standing state.
void BodyOutputs::greet(const BodyTopics& topics) const {
  const std::size_t body = topics.body;
  const auto greetWith = [&](const auto& topic, const auto& toMessage) {
    if (topic.greetWith) topic.greetWith(shown_.greeting(toMessage, body));
  };
  greetWith(topics.odometry, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.odometry(body, snapshot, stamp);
  });
  greetWith(topics.acceleration, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.acceleration(body, snapshot, snapshot.motions({body})[0], stamp);
  });
  greetWith(topics.applied_wrench, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.appliedWrench(body, snapshot, stamp);
  });
  greetWith(topics.pivot_force, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.pivotForce(body, snapshot, snapshot.motions({body})[0], stamp);
  });
  greetWith(topics.actuators, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.actuators(body, snapshot, stamp);
  });
}

void BodyOutputs::findAsked() {
  asked_.clear();
  for (const BodyTopics& topics : topics_)
    if (topics.odometry.subscribers() > 0 || topics.acceleration.subscribers() > 0 ||
        topics.applied_wrench.subscribers() > 0 || topics.actuators.hasSubscribers() ||
        topics.pivot_force.hasSubscribers())
      asked_.push_back(&topics);
}

void BodyOutputs::publish(const Snapshot& snapshot, const ros::Time& stamp) const {
  for (const BodyTopics* of_body : asked_) {
    const BodyTopics& topics = *of_body;
    if (shown_.isAbsent(topics.body)) continue;
    if (topics.odometry.subscribers())
      topics.odometry.publish(messages_.odometry(topics.body, snapshot, stamp), stamp);
    if (topics.applied_wrench.subscribers())
      topics.applied_wrench.publish(messages_.appliedWrench(topics.body, snapshot, stamp), stamp);
    if (topics.actuators.hasSubscribers())
      topics.actuators.publish(messages_.actuators(topics.body, snapshot, stamp), stamp);
  }
  publishMotions(snapshot, stamp);
}

/// All at once: bodies that act on one another share the work.
void BodyOutputs::publishMotions(const Snapshot& snapshot, const ros::Time& stamp) const {
  std::vector<const BodyTopics*> asked;
  std::vector<std::size_t> bodies;
  for (const BodyTopics* topics : asked_) {
    if (shown_.isAbsent(topics->body)) continue;
    if (!topics->acceleration.subscribers() && !topics->pivot_force.hasSubscribers()) continue;
    asked.push_back(topics);
    bodies.push_back(topics->body);
  }
  if (asked.empty()) return;
  const std::vector<BodyMotion> motions = snapshot.motions(bodies);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const BodyTopics& topics = *asked[k];
    if (topics.acceleration.subscribers())
      topics.acceleration.publish(messages_.acceleration(bodies[k], snapshot, motions[k], stamp),
                                  stamp);
    if (topics.pivot_force.hasSubscribers())
      topics.pivot_force.publish(messages_.pivotForce(bodies[k], snapshot, motions[k], stamp),
                                 stamp);
  }
}

}  // namespace rigid_body_sim
