#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/options/node_options.hpp"
#include "ros/outputs/body_markers.hpp"
#include "ros/outputs/body_messages.hpp"
#include "ros/outputs/body_outputs.hpp"
#include "ros/outputs/contact_output.hpp"
#include "ros/outputs/imu_output.hpp"
#include "ros/outputs/instants.hpp"
#include "ros/outputs/live_markers.hpp"
#include "ros/outputs/output_topics.hpp"
#include "ros/outputs/shown_bodies.hpp"
#include "ros/outputs/shown_state.hpp"
#include "ros/outputs/snapshot.hpp"

namespace rigid_body_sim {

/// What a run publishes, on ROS or into a bag: moving bodies on /tf, <body>/odom, <body>/accel,
/// <body>/applied_wrench, <body>/pivot_force and <body>/actuators, all bodies on ~states, what
/// touches on ~contacts, what springs and tethers exert on ~law_forces, at the instants k /
/// publish_rate of simulation time, /clock at k / clock_rate, each IMU at k / rate of its own,
/// whether a step ends there or not; once, latched: fixed bodies, named points and IMUs on
/// /tf_static, and ~markers, both anew where bodies come in or leave. Without subscribers nothing
/// is computed. Stamps strictly increase while time runs. While it stands, whoever comes is sent
/// the standing state.
class Outputs {
 public:
  /// The simulation, that of the scene, and the origin are watched, not copied.
  Outputs(OutputTopics topics, const NodeOptions& options, const Scene& scene,
          const Simulation& simulation, const TimeOrigin& origin);
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Takes in a body of the world, with the topics of its own that it is to have: it is on ~states
  /// and, if it moves, on /tf from now on. Gives it back: its topics end.
  void add(std::size_t body, std::optional<BodyTopics> topics);
  void remove(std::size_t body);

  /// [s] The next instant at which something is to be published, if it lies before the next step.
  /// What is due at a step is published after it, by publishDue.
  std::optional<double> instantWithinStep() const;

  /// [s] No instant at which something is to be published is before; the present where every step
  /// counts.
  double nextInstant() const;

  /// Whether anybody is sent what is due at an instant, but for /clock and the IMUs.
  bool isWatched();

  /// Publishes what is due at that instant, or at all instants before the next step up to t_end
  /// [s].
  void publishInstant(double t);
  void publishWithinStep(double t_end);

  /// Publishes what is due at the present step.
  void publishDue();

  /// Publishes the state of the present step whether due or not, unless it has been already.
  void publishNow();

  /// Whether time stands. Then whoever subscribes is sent the standing state at once.
  void setStanding(bool standing) { shown_.setStanding(standing); }

  /// While time stands: /clock again, and the standing state, but not /tf, where a repeated stamp
  /// raises a warning in every listener.
  void repeatClock();
  void repeatState();

  /// See BodyMarkers::repeat.
  void repeatBodies();

  /// Time has been set to t [s], or its stamps have been moved.
  void restart(double t);

  /// To be called when another simulation is watched, and after every input: bodies may have come
  /// in or left. One that is absent is on no topic, and viewers draw it no longer.
  void followBodies();

  /// Another simulation of the same scene is watched from now on.
  void watch(const Simulation& simulation) {
    shown_.watch(simulation);
    takeInput();
  }

  /// To be called after an input that may come after a state within the step has been published.
  void takeInput() {
    within_.restart();
    imus_.takeInput();
  }

  /// See BodyMessages::follow; nothing: no body is followed any more.
  void follow(std::optional<std::size_t> body) { messages_.follow(body); }

  /// Bodies have been moved other than by time.
  void breakTrails() { live_markers_.breakTrails(); }

  /// The last stamp of a state or a clock; that of the present step where there was none.
  ros::Time lastStamp() const { return shown_.lastStamp(); }

  /// [s] The last time that has been published, or that of the present step if that is later.
  double shownTime() const { return shown_.time(); }

 private:
  void publishOnce();
  void greet();
  void take(std::size_t body, std::optional<BodyTopics> topics);
  void listBodies();
  std::set<std::string> absentBodies() const;
  void publishAt(double t, double reach);
  void publishState(double t, bool with_markers);
  void publishClock(double t);
  void publishAsked(const Snapshot& snapshot, const ros::Time& stamp);
  void setStates(const Snapshot& snapshot, const ros::Time& stamp);
  double nextOfAll() const;
  bool asksForState();

  OutputTopics topics_;  // but for those of single bodies
  const TimeOrigin& origin_;
  ShownState shown_;
  StatesWithin within_;  // the step of what is shown, at state_instants_
  BodyMessages messages_;
  ShownBodies bodies_;
  BodyOutputs body_outputs_;
  std::optional<std::size_t> asked_changes_;  // of subscribers; see asksForState
  bool asks_for_state_ = false;               // as of then
  bool publish_clock_;
  Instants state_instants_;
  Instants clock_instants_;
  Instants marker_instants_;
  std::optional<ros::Time> greeted_;  // on /tf, while time stood
  BodyStates states_;                 // of the bodies that are present, kept for its names
  ContactOutput contacts_;
  ImuOutput imus_;
  LiveMarkers live_markers_;
  BodyMarkers markers_;
};

}  // namespace rigid_body_sim
