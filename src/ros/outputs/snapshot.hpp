#pragma once

#include <vector>

#include <rigid_body_sim/dynamics/line_force.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/step_sampler.hpp>

namespace rigid_body_sim {

/// The bodies and the wrenches that act on them at one instant: at the present step of a simulation
/// or within the next one. Lives no longer than the simulation stays at that step, and until the
/// next one of the same step.
class Snapshot {
 public:
  /// t [s]: from the present to the end of the next step. Throws SimulationDiverged.
  Snapshot(const Simulation& simulation, double t)
      : simulation_(simulation),
        within_step_(t > simulation.time()),
        state_(simulation.sample(within_step_ ? t : simulation.time())) {}

  /// The same by states within that step, each of which goes on from the one before.
  Snapshot(const Simulation& simulation, StatesWithin& within, double t)
      : simulation_(simulation),
        within_(&within),
        within_step_(t > simulation.time()),
        state_(within_step_ ? within.at(simulation, t) : simulation.sample(simulation.time())) {}

  double time() const { return state_.t; }

  const World& world() const { return simulation_.world(); }

  const std::vector<BodyState>& bodies() const { return state_.bodies; }

  /// How these bodies move and accelerate.
  std::vector<BodyMotion> motions(const std::vector<std::size_t>& bodies) const {
    return within_step_ && within_ ? within_->motions(simulation_, bodies, state_.t)
                                   : simulation_.motions(bodies, state_.t);
  }

  std::vector<PointWrench> activeWrenches(std::size_t body) const {
    return within_step_ ? simulation_.activeWrenches(body, state_.t)
                        : simulation_.activeWrenches(body);
  }

  std::vector<ContactPoint> contacts() const { return contactsOf(world(), state_); }

  std::vector<LineForce> lineForces() const { return lineForcesOf(world(), state_); }

  /// What the actuators of a body do, in the order of Body::actuators.
  std::vector<ActuatorReading> actuators(std::size_t body) const {
    return readActuators(world().bodies[body], state_, body);
  }

  /// Sum of the wrenches applied to a body, without gravity, laws and actuators.
  Wrench appliedWrench(std::size_t body) const {
    Wrench sum;
    for (const PointWrench& applied : activeWrenches(body)) addPointWrench(applied, bodies(), sum);
    return sum;
  }

 private:
  const Simulation& simulation_;
  StatesWithin* within_ = nullptr;
  bool within_step_;
  State state_;
};

}  // namespace rigid_body_sim
