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
  const Body& added = shown_.world().bodies[body];
  bodies_.add(body);
  if (!added.fixed) live_markers_.add(body, 0.02 * sizeOf(added));
  if (!topics) return;
  for (ImuTopics& of_imu : std::exchange(topics->imus, {})) {
    const Imu& imu = shown_.world().imus[of_imu.imu];
    imus_.add(imu, added, std::move(of_imu), messages_.frames().of(body, imu.name), shownTime());
  }
  if (added.fixed) return;
  body_outputs_.add(std::move(*topics));
  asked_changes_.reset();
}

void Outputs::remove(std::size_t body) {
  bodies_.remove(body);
  listBodies();
  live_markers_.remove(body);
  imus_.remove(body);
  body_outputs_.remove(body);
  asked_changes_.reset();
}

/// Makes what depends on which bodies there are.
void Outputs::listBodies() {
  bodies_.list(shown_.world());
  states_ = emptyBodyStates(shown_.world(), bodies_.present(), messages_.worldFrame());
}

std::set<std::string> Outputs::absentBodies() const {
  std::set<std::string> absent;
  for (const Body& body : shown_.world().bodies)
    if (body.absent) absent.insert(body.name);
  return absent;
}

void Outputs::followBodies() {
  const ShownBodies::Changes changes = bodies_.follow(shown_.simulation());
  if (!changes.any()) return;
  const World& world = shown_.world();
  std::set<std::string> leaving;
  std::vector<std::size_t> entering;
  bool frames_changed = false;
  for (const std::size_t body : changes.left) {
    frames_changed |= messages_.hasFramesOn(body);
    leaving.insert(world.bodies[body].name);
    live_markers_.endTrail(body);
  }
  for (const std::size_t body : changes.entered) {
    frames_changed |= messages_.hasFramesOn(body);
    if (moves(world.bodies[body])) entering.push_back(body);
  }
  listBodies();
  const ros::Time stamp = origin_.stamp(shownTime());
  // latched: whoever comes later has the frames of the bodies that are present
  if (frames_changed)
    topics_.tf_static.publish(messages_.fixedTransforms(shown_.simulation(), stamp), stamp);
  // not latched: whoever comes later is not to delete anything
  if (!leaving.empty()) topics_.live_markers.publish(markers_.deletions(leaving), stamp);
  markers_.publish(absentBodies(), stamp);
  if (!shown_.isStanding()) return;
  // while time stands no state is due that would show them
  if (!entering.empty() && topics_.tf.subscribers() > 0)
    topics_.tf.publish(messages_.transforms(entering, shown_.snapshot(), stamp), stamp);
  // the trail, arrows and lines of those that leave
  if (live_markers_.hasSubscribers()) live_markers_.publish(shown_.snapshot(), stamp);
}

}  // namespace rigid_body_sim
