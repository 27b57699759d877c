#include "ros/outputs/live_markers.hpp"

#include <utility>

#include "ros/outputs/arrow_markers.hpp"
#include "ros/outputs/law_forces.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

void append(const std::vector<Marker>& more, MarkerArray& all) {
  all.markers.insert(all.markers.end(), more.begin(), more.end());
}

/// Numbers the markers within their namespaces. Returns how many there are of each.
std::map<std::string, int> number(MarkerArray& all) {
  std::map<std::string, int> count;
  for (Marker& marker : all.markers) marker.id = count[marker.ns]++;
  return count;
}

int firstTrailId(std::size_t body) { return static_cast<int>(body) * Trail::kStrips; }

void appendDeletion(const std::string& name_space, int id, MarkerArray& all) {
  Marker marker;
  marker.action = Marker::DELETE;
  marker.ns = name_space;
  marker.id = id;
  all.markers.push_back(marker);
}

}  // namespace

LiveMarkers::LiveMarkers(Topic<MarkerArray> topic, const std::string& world_frame,
                         std::vector<std::string> body_frames)
    : world_frame_(world_frame), body_frames_(std::move(body_frames)), topic_(std::move(topic)) {}

void LiveMarkers::add(std::size_t body, double trail_width) {
  trails_.emplace(body, Trail(firstTrailId(body), trail_width));
}

void LiveMarkers::remove(std::size_t body) {
  rotors_.erase(body);
  if (trails_.erase(body) == 0 || !known_) return;
  for (int i = 0; i < Trail::kStrips; ++i) ended_trails_.push_back(firstTrailId(body) + i);
}

void LiveMarkers::endTrail(std::size_t body) {
  const auto trail = trails_.find(body);
  if (trail == trails_.end() || !known_) return;
  trail->second.breakOff();
  for (int i = 0; i < Trail::kStrips; ++i) ended_trails_.push_back(firstTrailId(body) + i);
}

void LiveMarkers::forget() {
  if (!known_) return;
  known_ = false;
  shown_.clear();
  ended_trails_.clear();
  breakTrails();
}

void LiveMarkers::publish(const Snapshot& snapshot, const ros::Time& stamp) {
  known_ = true;
  MarkerArray all;
  addRotors(snapshot, all);
  addArrows(snapshot, all);
  const std::map<std::string, int> shown = number(all);
  deleteEnded(shown, all);
  addTrails(snapshot, all);
  shown_ = shown;
  for (Marker& marker : all.markers) {
    if (marker.frame_locked) continue;  // in the frame of a body
    marker.header.frame_id = world_frame_;
    marker.header.stamp = stamp;
  }
  if (!all.markers.empty()) topic_.publish(all, stamp);
}

void LiveMarkers::breakTrails() {
  for (auto& [body, trail] : trails_) trail.breakOff();
}

void LiveMarkers::addArrows(const Snapshot& snapshot, MarkerArray& all) const {
  const std::vector<Body>& bodies = snapshot.world().bodies;
  const std::vector<BodyState>& states = snapshot.bodies();
  for (const auto& [body, trail] : trails_) {
    if (bodies[body].absent) continue;
    for (const PointWrench& applied : snapshot.activeWrenches(body))
      append(wrenchArrows(applied, bodies, states), all);
    if (!bodies[body].actuators.empty())
      append(actuatorArrows(bodies[body], body_frames_[body], snapshot.actuators(body)), all);
    append(momentumArrows(bodies[body], states[body]), all);
  }
  for (const ContactPoint& contact : snapshot.contacts())
    append(contactArrows(contact, bodies), all);
  for (const LineForce& line : snapshot.lineForces())
    all.markers.push_back(lineMarker(line, snapshot.world()));
}

/// Of the bodies with rotors that have been taken in.
void LiveMarkers::addRotors(const Snapshot& snapshot, MarkerArray& all) {
  for (const auto& [body, trail] : trails_) {
    const Body& shown = snapshot.world().bodies[body];
    if (shown.actuators.empty() || shown.absent) continue;
    const auto rotors = rotors_.try_emplace(body, body_frames_[body], shown).first;
    append(rotors->second.at(snapshot.time(), snapshot.actuators(body)), all);
  }
}

/// Deletes the arrows shown before beyond those that are shown now, and trails that have ended.
void LiveMarkers::deleteEnded(const std::map<std::string, int>& shown, MarkerArray& all) {
  for (const auto& [name_space, before] : shown_) {
    const auto now = shown.find(name_space);
    for (int id = now == shown.end() ? 0 : now->second; id < before; ++id)
      appendDeletion(name_space, id, all);
  }
  for (const int id : std::exchange(ended_trails_, {})) appendDeletion(Trail::kNamespace, id, all);
}

void LiveMarkers::addTrails(const Snapshot& snapshot, MarkerArray& all) {
  for (auto& [body, trail] : trails_) {
    if (snapshot.world().bodies[body].absent) continue;
    const std::optional<Marker> strip = trail.add(snapshot.bodies()[body].x_W);
    if (strip) all.markers.push_back(*strip);
  }
}

}  // namespace rigid_body_sim
