#include "dynamics/run/run_motors.hpp"

#include <utility>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/actuators/actuator_start.hpp"

namespace rigid_body_sim {

RunMotors::RunMotors(const World& world, const State& start)
    : commanded_(!start.actuators.empty()) {
  if (!hasActuators(world)) return;
  for (const Body& body : world.bodies)
    tables_.push_back(body.actuators.empty()
                          ? nullptr
                          : std::make_shared<const ActuatorTable>(actuatorTable(body)));
}

std::shared_ptr<const State> RunMotors::complete(const World& world,
                                                 std::shared_ptr<const State> start) {
  if (!hasActuators(world)) return start;
  return std::make_shared<const State>(withActuators(world, *start));
}

void RunMotors::place(RunState& run, const State& start, bool scheduled) const {
  if (tables_.empty()) return;
  for (std::size_t i = 0; i < tables_.size(); ++i)
    if (tables_[i]) run.schedules[i].setActuators(ActuatorSchedule(tables_[i], start.actuators[i]));
  if (!scheduled) return;
  for (ActuatorCommand command : run.world->commands) {
    command.start = onStep(command.start, run.world->solver.time_step);
    if (commanded_ && command.start <= run.time) continue;
    run.schedules[command.body].command(command, run.time);
  }
}

std::vector<std::vector<ActuatorState>> RunMotors::states(
    const std::vector<WrenchSchedule>& schedules) const {
  std::vector<std::vector<ActuatorState>> states;
  if (tables_.empty()) return states;
  for (const WrenchSchedule& schedule : schedules)
    states.push_back(schedule.actuators() ? schedule.actuators()->states()
                                          : std::vector<ActuatorState>());
  return states;
}

BodyState RunMotors::follow(RunState& run, std::size_t body, const BodyState& state) const {
  BodyState now = state;
  WrenchSchedule& schedule = run.schedules[body];
  const ActuatorSchedule* actuators = schedule.actuators();
  if (!actuators) return now;
  const Vector3d& inv_I = run.world->bodies[body].inv_I;
  schedule.followJump(angularVelocity(inv_I, run.at(body, run.time).L_P),
                      angularVelocity(inv_I, state.L_P), run.time);
  if (hasSpin(actuators->table()))
    now.L_W = totalMomentum(now, momentumOf(actuators->table(), actuators->states(), run.time));
  return now;
}

}  // namespace rigid_body_sim
