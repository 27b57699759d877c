#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include <ros/time.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/outputs/snapshot.hpp"

namespace rigid_body_sim {

/// Which simulation is shown, and how far: the last stamps of a state and of /clock, which strictly
/// increase while time runs, and whether time stands.
class ShownState {
 public:
  /// Both are watched, not copied.
  ShownState(const Simulation& simulation, const TimeOrigin& origin)
      : simulation_(&simulation), origin_(origin) {}
  ShownState(const ShownState&) = delete;
  ShownState& operator=(const ShownState&) = delete;

  const Simulation& simulation() const { return *simulation_; }
  const World& world() const { return simulation_->world(); }
  bool isAbsent(std::size_t body) const { return world().bodies[body].absent; }

  /// Another simulation of the same scene is shown from now on.
  void watch(const Simulation& simulation) { simulation_ = &simulation; }

  bool isStanding() const { return standing_; }
  void setStanding(bool standing) { standing_ = standing; }

  /// [s] The last time that has been published, or that of the present step if that is later.
  double time() const { return std::max(last_t_, simulation_->time()); }
  Snapshot snapshot() const { return Snapshot(*simulation_, time()); }

  /// Something has been published at t [s].
  void note(double t) { last_t_ = t; }

  /// The stamp of a state, or of /clock, that is published at t [s]; nothing where the last one is
  /// not before it.
  std::optional<ros::Time> takeState(double t) { return take(t, last_state_); }
  std::optional<ros::Time> takeClock(double t) { return take(t, last_clock_); }

  /// The last stamp of a state or a clock; that of the present step where there was none.
  ros::Time lastStamp() const {
    if (!last_state_ && !last_clock_) return origin_.stamp(simulation_->time());
    return std::max(last_state_.value_or(ros::Time()), last_clock_.value_or(ros::Time()));
  }

  /// Nothing has been published yet at the time that is now.
  void restart() {
    last_state_ = last_clock_ = std::nullopt;
    last_t_ = 0;
  }

  /// What is sent to a subscriber that comes while time stands: to it alone, so that every
  /// subscriber receives strictly increasing stamps. body: whose topic it is; while that is absent
  /// nothing is sent.
  template <class ToMessage>
  auto greeting(ToMessage toMessage, std::optional<std::size_t> body = std::nullopt) const {
    return [this, toMessage, body]() {
      using Message = decltype(toMessage(snapshot(), ros::Time()));
      if (!standing_ || (body && isAbsent(*body))) return std::optional<Message>();
      const Snapshot standing = snapshot();
      return std::optional<Message>(toMessage(standing, origin_.stamp(standing.time())));
    };
  }

 private:
  using LastStamp = std::optional<ros::Time>;  // none yet; zero is a stamp like others

  std::optional<ros::Time> take(double t, LastStamp& last) {
    const ros::Time stamp = origin_.stamp(t);
    if (stamp <= last) return std::nullopt;
    last = stamp;
    last_t_ = t;
    return stamp;
  }

  const Simulation* simulation_;
  const TimeOrigin& origin_;
  bool standing_ = false;
  LastStamp last_state_, last_clock_;
  double last_t_ = 0;
};

}  // namespace rigid_body_sim
