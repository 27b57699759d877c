#include <memory>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/run/group.hpp"

/// The motors of a group.
namespace rigid_body_sim {

/// After all other laws with states of their own.
void Group::addActuators(const std::vector<WrenchSchedule>& schedules) {
  for (std::size_t k = 0; k < bodies_.members.size(); ++k) {
    const ActuatorSchedule* actuators = schedules[bodies_.members[k]].actuators();
    if (!actuators) continue;
    auto law = std::make_shared<const ActuatorLaw>(k, *actuators);
    system_.driven.push_back({law.get(), k, present_.laws.size()});
    system_.stateful_laws.push_back({std::move(law), present_.laws.size()});
    system_.law_states_change = true;
    present_.laws.push_back(t_ - system_.driven.back().law->drive().start);
  }
}

/// Anew, from an event on.
void Group::gatherActuators(const std::vector<WrenchSchedule>& schedules) {
  auto stateful = system_.stateful_laws.begin() +
                  static_cast<std::ptrdiff_t>(system_.stateful_laws.size() - system_.driven.size());
  for (System::Driven& driven : system_.driven) {
    const std::size_t body = bodies_.members[driven.body];
    auto law = std::make_shared<const ActuatorLaw>(driven.body, *schedules[body].actuators());
    driven.law = law.get();
    const ActuatorDrive& drive = law->drive();
    system_.held[driven.body].drive = drive.isIdle() ? nullptr : &drive;
    (stateful++)->law = std::move(law);
  }
}

/// The time of motors is never accumulated from step to step.
void Group::setClocks(double t, std::vector<double>& laws) const {
  for (const System::Driven& driven : system_.driven)
    laws[driven.state] = t - driven.law->drive().start;
}

}  // namespace rigid_body_sim
