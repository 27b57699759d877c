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
    imus_.add(imu, added, std::move(of_imu), frames_.of(body, imu.name), shownTime());
  }
  if (added.fixed) return;
  greet(*topics);
  topics_.bodies.push_back(std::move(*topics));
}

void Outputs::remove(std::size_t body) {
  const auto is_body = [body](const auto& topics) { return topics.body == body; };
  listed_.erase(std::remove(listed_.begin(), listed_.end(), body), listed_.end());
  listBodies();
  live_markers_.remove(body);
  imus_.remove(body);
  topics_.bodies.erase(std::remove_if(topics_.bodies.begin(), topics_.bodies.end(), is_body),
                       topics_.bodies.end());
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
  states_ = emptyBodyStates(world, present_, world_frame_);
}

visualization_msgs::MarkerArray Outputs::presentMarkers() const {
  std::set<std::string> absent;
  for (const Body& body : simulation_->world().bodies)
    if (body.absent) absent.insert(body.name);
  visualization_msgs::MarkerArray present;
  for (const visualization_msgs::Marker& marker : all_bodies_.markers)
    if (absent.count(marker.ns) == 0) present.markers.push_back(marker);
  return present;
}

void Outputs::followBodies() {
  const std::vector<Body>& bodies = simulation_->world().bodies;
  if (&bodies == followed_bodies_) return;  // where bodies have changed, they are others
  followed_bodies_ = &bodies;
  std::set<std::string> leaving;
  bool changed = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].absent == absent_[i]) continue;
    changed = true;
    if (!bodies[i].absent) continue;
    leaving.insert(bodies[i].name);
    live_markers_.endTrail(i);
  }
  if (!changed) return;
  listBodies();
  bodies_ = presentMarkers();
  visualization_msgs::MarkerArray deleted;
  for (visualization_msgs::Marker marker : all_bodies_.markers) {
    if (leaving.count(marker.ns) == 0) continue;
    marker.action = visualization_msgs::Marker::DELETE;
    deleted.markers.push_back(std::move(marker));
  }
  const ros::Time stamp = origin_.stamp(shownTime());
  if (!deleted.markers.empty()) topics_.live_markers.publish(deleted, stamp);
  topics_.markers.publish(bodies_, stamp);
}

}  // namespace rigid_body_sim
