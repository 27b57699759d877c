#include <memory>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/actuators/actuator_start.hpp"
#include "dynamics/run/run.hpp"

/// The motors of a run: how they start, and what is asked of them.
namespace rigid_body_sim {

/// For a world with actuators.
void Run::takeActuators() {
  for (const Body& body : world_->bodies)
    if (!body.actuators.empty()) planner_.requireSupport(needsOf(actuatorTable(body)), body.name);
  commanded_ = !start_->actuators.empty();
  start_ = std::make_shared<const State>(withActuators(*world_, *start_));
}

/// scheduled: with those commands of the scene that the state has not taken yet.
void Run::placeActuators(const State& start, bool scheduled) {
  for (std::size_t i = 0; i < world_->bodies.size(); ++i)
    if (!world_->bodies[i].actuators.empty())
      schedules_[i].setActuators(
          ActuatorSchedule(std::make_shared<const ActuatorTable>(actuatorTable(world_->bodies[i])),
                           start.actuators[i]));
  if (!scheduled) return;
  for (ActuatorCommand command : world_->commands) {
    command.start = onStep(command.start, world_->solver.time_step);
    if (commanded_ && command.start <= time_) continue;
    schedules_[command.body].command(command, time_);
  }
}

std::vector<std::vector<ActuatorState>> Run::actuatorStates(
    const std::vector<WrenchSchedule>& schedules) const {
  std::vector<std::vector<ActuatorState>> states;
  for (const WrenchSchedule& schedule : schedules)
    states.push_back(schedule.actuators() ? schedule.actuators()->states()
                                          : std::vector<ActuatorState>());
  return states;
}

/// What is to come changes nothing before: the motion stays anchored where it is.
void Run::command(const ActuatorCommand& command) {
  const std::size_t body = command.body;
  schedules_[body].command(command, time_);
  disturb(body);
  if (command.start <= time_)
    restartGroup(body);
  else
    groups_.forgetKnown(groups_.indexOf(body));
}

void Run::setState(std::size_t body, const BodyState& state) {
  disturb(body);
  BodyState now = state;
  if (const ActuatorSchedule* actuators = schedules_[body].actuators()) {
    const Vector3d& inv_I = world_->bodies[body].inv_I;
    schedules_[body].followJump(angularVelocity(inv_I, this->body(body).L_P),
                                angularVelocity(inv_I, state.L_P), time_);
    if (hasSpin(actuators->table()))
      now.L_W = totalMomentum(now, momentumOf(actuators->table(), actuators->states(), time_));
  }
  restartGroup(body);
  groups_.of(body).setState(groups_.memberOf(body), now);
  restartContacts(body);
}

}  // namespace rigid_body_sim
