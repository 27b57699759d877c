#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/actuators/actuator_schedule.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// The wrench with a start or end that misses the end of a step of h [s] by rounding moved there:
/// 0.1 s + 0.2 s is 300 steps of 1 ms, and not a step that is split 6e-17 s after its start. So
/// short a wrench that this would change its impulse keeps it.
PointWrench onSteps(PointWrench wrench, double h);

/// The same for an instant by itself.
double onStep(double t, double h);

/// The wrenches applied to one body: those that act, and those to come in order of their start. Of
/// a body with actuators also what these do: their events are events of the schedule.
class WrenchSchedule {
 public:
  /// Adds a wrench. In a named slot, what was there ends where it starts; what would start then or
  /// later is dropped. An empty slot always adds. A start before `now` means now, at the same
  /// duration; a wrench without duration is dropped.
  void put(const std::string& slot, PointWrench wrench, double now);

  void setActuators(ActuatorSchedule actuators);

  /// Everything that acts and is to come.
  BodySchedule entries() const;

  /// Takes over what another schedule had at time t [s]; for one that is empty, with its actuators.
  void restore(const BodySchedule& entries, double t);

  /// Null where the body has none.
  const ActuatorSchedule* actuators() const { return actuators_ ? &*actuators_ : nullptr; }

  /// Commands an actuator of the body; see ActuatorSchedule::put.
  void command(const ActuatorCommand& command, double now);

  /// See ActuatorSchedule::followJump.
  void followJump(const Vector3d& w_before_P, const Vector3d& w_after_P, double t);

  /// Drops all, or what a slot holds. Returns whether there was anything.
  bool clear();
  bool clear(const std::string& slot);

  /// Whether a wrench of the slot, which must have a name, acts or is to come.
  bool holds(const std::string& slot) const;

  /// Wrenches that start at or before t join, those that end at or before t leave. Returns whether
  /// that changed what acts.
  bool advanceTo(double t);

  /// Starts a transaction: takeBack rolls back what advanceTo changes, accept commits it; nothing
  /// else may change the schedule meanwhile.
  void beginStep();
  bool isInStep() const { return before_.has_value(); }
  void takeBack();
  void accept();

  /// [s] the next instant at which advanceTo changes something; infinity when none is to come.
  double nextEvent() const { return next_event_; }

  /// [s] the next of these instants that concerns a wrench which HeldWrench does not hold: bodies
  /// are linked or parted there.
  double nextCoupling() const { return next_coupling_; }

  /// [s] when a wrench first begins to link its body with one that is not among these, ascending.
  double nextLink(const std::vector<std::size_t>& bodies) const;

  /// Adds the bodies that wrenches link which start or end by time t; and those linked now.
  void addLinked(double t, std::vector<std::size_t>& bodies) const;

  const std::vector<PointWrench>& active() const { return active_; }

  /// What will act at a time t [s] that is not past, unless something is put or cleared.
  std::vector<PointWrench> activeAt(double t) const;
  std::size_t size() const { return active_.size() + pending_.size(); }

  /// Whether all that act depend on the motion of their own body only (HeldWrench::holds).
  bool allHeld() const;

 private:
  struct Pending {
    std::string slot;
    PointWrench wrench;
  };
  /// How a step found the schedule.
  struct Before {
    std::vector<PointWrench> active;
    std::vector<std::string> active_slots;
    std::vector<std::pair<double, Pending>> started;
  };
  void findNextEvent();

  std::vector<PointWrench> active_;
  std::vector<std::string> active_slots_;   // of active_, index by index
  std::multimap<double, Pending> pending_;  // by start
  std::optional<Before> before_;            // within a step
  std::optional<ActuatorSchedule> actuators_;
  double next_event_ = std::numeric_limits<double>::infinity();
  bool couples_ = false;  // whether any, since all were cleared, was not held
  double next_coupling_ = std::numeric_limits<double>::infinity();
};

}  // namespace rigid_body_sim
