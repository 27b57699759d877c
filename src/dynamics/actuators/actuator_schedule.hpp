#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "dynamics/actuators/actuator_drive.hpp"

namespace rigid_body_sim {

/// The actuators of one body: what they do, and the commands to come. Their events are the instants
/// at which a command starts or ends, a speed passes zero, or a lag has died away.
class ActuatorSchedule {
 public:
  ActuatorSchedule(std::shared_ptr<const ActuatorTable> table, std::vector<ActuatorState> states);

  const ActuatorTable& table() const { return *table_; }
  const std::shared_ptr<const ActuatorTable>& sharedTable() const { return table_; }
  const std::vector<ActuatorState>& states() const { return states_; }

  /// Adds a command; a start before `now` means now, at the same duration.
  void put(ActuatorCommand command, double now);
  std::size_t commandsToCome() const { return pending_.size(); }

  /// By start, then as they came.
  std::vector<ActuatorCommand> toCome() const;

  /// Takes every event up to t, in order. Returns whether there was any.
  bool advanceTo(double t);

  /// [s] the next event; infinity when none is to come.
  double nextEvent() const { return next_event_; }

  /// Keeps the speeds of wheels relative to the body where its angular velocity jumps at time t.
  void followJump(const Vector3d& w_before_P, const Vector3d& w_after_P, double t);

  /// A transaction, as of WrenchSchedule.
  void beginStep();
  void takeBack();
  void accept() { before_.reset(); }

 private:
  /// How a step found it.
  struct Before {
    std::vector<ActuatorState> states;
    std::vector<std::pair<double, ActuatorCommand>> started;
  };
  void start(const ActuatorCommand& command, double t);
  void setCommand(std::size_t k, double u, double t);
  double nextOf(std::size_t k) const;
  void passEvent(std::size_t k, double t);
  void findNextEvent();

  std::shared_ptr<const ActuatorTable> table_;
  std::vector<ActuatorState> states_;
  std::multimap<double, ActuatorCommand> pending_;  // by start, then as they came
  std::optional<Before> before_;                    // within a step
  double next_event_ = 0;
};

}  // namespace rigid_body_sim
