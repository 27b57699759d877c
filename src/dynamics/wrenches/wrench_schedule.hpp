#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// The wrenches applied to one body: those that act, and those to come in order of their start.
class WrenchSchedule {
 public:
  /// Adds a wrench. In a named slot it takes over from the slot's former one at its own start;
  /// what the slot held for later is dropped. An empty slot always adds. A start before `now` means
  /// now, at the same duration; a wrench without duration is dropped.
  void put(const std::string& slot, PointWrench wrench, double now);

  /// Drops all, or what a slot holds. Returns whether there was anything.
  bool clear();
  bool clear(const std::string& slot);

  /// Whether a wrench of the slot, which must have a name, acts or is to come.
  bool holds(const std::string& slot) const;

  /// Wrenches that start at or before t join, those that end at or before t leave. Returns whether
  /// that changed what acts.
  bool advanceTo(double t);

  /// From now on it is kept in mind what advanceTo changes, until that is taken back or accepted;
  /// nothing else may change it meanwhile.
  void beginStep();
  void takeBack();
  void accept();

  /// [s] the next instant at which advanceTo changes something; infinity when none is to come.
  double nextEvent() const { return next_event_; }

  const std::vector<PointWrench>& active() const { return active_; }
  std::size_t size() const { return active_.size() + pending_.size(); }

  /// Whether all, acting or to come, depend on the motion of their own body only
  /// (HeldWrench::holds).
  bool allHeld() const;

  /// The bodies, acted on or turned with, of all wrenches that act or are to come.
  std::vector<std::size_t> bodies() const;

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
  double next_event_ = std::numeric_limits<double>::infinity();
};

}  // namespace rigid_body_sim
