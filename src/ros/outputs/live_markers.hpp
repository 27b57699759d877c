#pragma once

#include <map>
#include <string>
#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include "ros/outputs/rotor_markers.hpp"
#include "ros/outputs/snapshot.hpp"
#include "ros/outputs/topic.hpp"
#include "ros/outputs/trail.hpp"

namespace rigid_body_sim {

/// What changes on ~markers, beside the bodies themselves: rotors that turn, arrows of the wrenches
/// that act, of actuators, of the forces of contact and of angular momentum, the lines of springs
/// and tethers, and the trails of the centres of mass of the moving bodies. Computed while somebody
/// looks: a trail starts then.
class LiveMarkers {
 public:
  /// body_frames: those of all bodies of the world on tf.
  LiveMarkers(Topic<visualization_msgs::MarkerArray> topic, const std::string& world_frame,
              std::vector<std::string> body_frames);

  /// Takes in a body that moves, by its index in the world, with the width of its trail [m]; gives
  /// it back: its trail and arrows go with the next message.
  void add(std::size_t body, double trail_width);
  void remove(std::size_t body);

  /// The trail of a body goes with the next message, and begins anew where the body goes on.
  void endTrail(std::size_t body);

  bool hasSubscribers() const { return topic_.subscribers() > 0; }

  void publish(const Snapshot& snapshot, const ros::Time& stamp);

  /// Nobody looks any more: who comes next has no arrows to delete, and sees new trails.
  void forget();

  /// The bodies have been moved: no line joins where they were to where they are.
  void breakTrails();

 private:
  void addArrows(const Snapshot& snapshot, visualization_msgs::MarkerArray& all) const;
  void addRotors(const Snapshot& snapshot, visualization_msgs::MarkerArray& all);
  void deleteEnded(const std::map<std::string, int>& shown, visualization_msgs::MarkerArray& all);
  void addTrails(const Snapshot& snapshot, visualization_msgs::MarkerArray& all);

  std::string world_frame_;
  std::vector<std::string> body_frames_;
  Topic<visualization_msgs::MarkerArray> topic_;
  std::map<std::string, int> shown_;            // arrows by namespace; ids count from 0
  std::map<std::size_t, Trail> trails_;         // by body
  std::vector<int> ended_trails_;               // of bodies given back: ids to delete
  std::map<std::size_t, RotorMarkers> rotors_;  // by body
  bool known_ = false;                          // whether a message has gone to who still looks
};

}  // namespace rigid_body_sim
