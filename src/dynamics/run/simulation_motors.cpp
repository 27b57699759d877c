#include <stdexcept>
#include <string>

#include "dynamics/run/check_input.hpp"
#include "dynamics/run/parts.hpp"
#include "dynamics/wrenches/delay.hpp"

/// What is asked of motors.
namespace rigid_body_sim {

void Simulation::command(const ActuatorCommand& command) {
  checkCommand(world(), command);
  std::size_t& at_most = parts_->commands_at_most;
  if (at_most >= kMaxCommands) at_most = parts_->commandsToCome();
  if (at_most >= kMaxCommands)
    throw std::invalid_argument("at most " + std::to_string(kMaxCommands) +
                                " commands may be to come");
  ActuatorCommand timed = command;
  timed.start = onStep(command.start, world().solver.time_step);
  timed.end = onStep(command.end, world().solver.time_step);
  delayTo(time(), timed);
  parts_->run.command(timed);
  ++at_most;
  if (parts_->error) parts_->error->command(timed);
}

std::vector<ActuatorReading> Simulation::actuators(std::size_t body) const {
  checkIndex(world(), body);
  std::vector<ActuatorReading> readings;
  const ActuatorSchedule* actuators = parts_->run.now().schedules[body].actuators();
  if (!actuators) return readings;
  const Body& constant = world().bodies[body];
  const Vector3d w_P = angularVelocity(constant.inv_I, this->body(body).L_P);
  const Vector3d w_B = constant.X_BP.linear() * w_P;
  for (std::size_t k = 0; k < constant.actuators.size(); ++k)
    readings.push_back(readActuator(constant.actuators[k], actuators->states()[k], time(), w_B));
  return readings;
}

std::int64_t Simulation::saturations() const {
  std::int64_t sum = 0;
  for (const WrenchSchedule& schedule : parts_->run.now().schedules) {
    if (!schedule.actuators()) continue;
    for (const ActuatorState& state : schedule.actuators()->states()) sum += state.saturations;
  }
  return sum;
}

}  // namespace rigid_body_sim
