#include <algorithm>
#include <set>
#include <utility>

#include "ros/outputs/arrow_markers.hpp"
#include "ros/outputs/outputs.hpp"
#include "ros/outputs/state_messages.hpp"

/// The bodies of the outputs: taken in and given back, present and absent.
namespace rigid_body_sim {

void Outputs::add(std::size_t body, std::optional<BodyTopics> topics) {
  take(body, std::move(topics));
  listBodies();
}

void Outputs::take(std::size_t body, std::optional<BodyTopics> topics) {
  const Body& added = simulation_->world().bodies[body];
  listed_.insert(std::lower_bound(listed_.begin(), listed_.end(), body), body);
  if (!added.fixed) live_markers_.add(body, 0.02 * sizeOf(added));
  if (!topics) return;
  for (ImuTopics& of_imu : std::exchange(topics->imus, {})) {
    const Imu& imu = simulation_->world().imus[of_imu.imu];
    imus_.add(imu, added, std::move(of_imu), messages_.frames().of(body, imu.name), shownTime());
  }
  if (added.fixed) return;
  greet(*topics);
  topics_.bodies.push_back(std::move(*topics));
  asked_changes_.reset();
}

void Outputs::remove(std::size_t body) {
  const auto is_body = [body](const auto& topics) { return topics.body == body; };
  listed_.erase(std::remove(listed_.begin(), listed_.end(), body), listed_.end());
  listBodies();
  live_markers_.remove(body);
  imus_.remove(body);
  topics_.bodies.erase(std::remove_if(topics_.bodies.begin(), topics_.bodies.end(), is_body),
                       topics_.bodies.end());
  asked_changes_.reset();
}

/// Makes what depends on which bodies there are.
void Outputs::listBodies() {
  const World& world = simulation_->world();
  moving_.clear();
  present_.clear();
  for (const std::size_t body : listed_) {
    if (moves(world.bodies[body])) moving_.push_back(body);
    if (!world.bodies[body].absent) present_.push_back(body);
    absent_[body] = world.bodies[body].absent;
  }
  states_ = emptyBodyStates(world, present_, messages_.worldFrame());
}

std::set<std::string> Outputs::absentBodies() const {
  std::set<std::string> absent;
  for (const Body& body : simulation_->world().bodies)
    if (body.absent) absent.insert(body.name);
  return absent;
}

void Outputs::followBodies() {
  if (simulation_->worldChanges() == followed_changes_) return;
  followed_changes_ = simulation_->worldChanges();
  const std::vector<Body>& bodies = simulation_->world().bodies;
  std::set<std::string> leaving;
  std::vector<std::size_t> entering;
  bool changed = false, frames_changed = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].absent == absent_[i]) continue;
    changed = true;
    frames_changed |= messages_.hasFramesOn(i);
    if (!bodies[i].absent) {
      if (moves(bodies[i])) entering.push_back(i);
      continue;
    }
    leaving.insert(bodies[i].name);
    live_markers_.endTrail(i);
  }
  if (!changed) return;
  listBodies();
  const ros::Time stamp = origin_.stamp(shownTime());
  // latched: whoever comes later has the frames of the bodies that are present
  if (frames_changed)
    topics_.tf_static.publish(messages_.fixedTransforms(*simulation_, stamp), stamp);
  // not latched: whoever comes later is not to delete anything
  if (!leaving.empty()) topics_.live_markers.publish(markers_.deletions(leaving), stamp);
  markers_.publish(absentBodies(), stamp);
  // while time stands no state is due that would show them
  if (standing_ && !entering.empty() && topics_.tf.subscribers() > 0)
    topics_.tf.publish(messages_.transforms(entering, shown(), stamp), stamp);
}

}  // namespace rigid_body_sim
