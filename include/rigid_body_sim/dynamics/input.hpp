#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>

#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// What changes a run from outside. Messages, services, records and programs all end in one of
/// these; the simulation takes it over between two steps (Simulation::apply).

/// A wrench is applied to a body that is not fixed.
struct WrenchInput {
  /// What acts on the body from this slot, or is to come from it, ends where this wrench starts;
  /// what would start then or later is dropped. Empty: always adds.
  std::string slot;
  PointWrench wrench;
};

/// Wrenches end now, those that act and those to come.
struct ClearInput {
  static constexpr std::size_t kEveryBody = std::numeric_limits<std::size_t>::max();
  std::size_t body = kEveryBody;  ///< index
  std::string slot;               ///< empty: of every slot, and those without
};

/// A body that is not fixed is put into a pose and a velocity.
struct StateInput {
  std::size_t body = 0;  ///< index
  BodyFrameMotion motion;
};

/// An actuator is commanded; commands with a later start stay.
struct CommandInput {
  ActuatorCommand command;
};

/// The velocity of the medium is set, from now on. A reset sets that of the scene.
struct WindInput {
  Vector3d velocity_W = Vector3d::Zero();  ///< [m/s]
};

/// The mass properties of a body that moves are set anew: fuel, a payload, a gripper. Its place,
/// its momentum p and its angular momentum about the world's origin are kept, so that its
/// velocities change. A reset sets those of the scene. See Simulation::setMassProperties.
struct MassInput {
  std::size_t body = 0;         ///< index
  MassProperties properties_B;  ///< with wheels and rotors, as if these stood still in it
};

/// A body that is absent comes in, or one that is present leaves; see Simulation::setPresent.
struct PresenceInput {
  std::size_t body = 0;                   ///< index
  std::optional<BodyFrameMotion> motion;  ///< with which it comes in; none: it leaves
};

/// Back to the initial states, every wrench and command cleared.
struct ResetInput {
  bool restart_time = false;  ///< also time and the schedule of the scene; else time runs on
};

/// On from a state as Simulation::state() gave it, of this run or another of the same world: the
/// same bits follow as there. A reset still leads to the start of this run.
struct LoadInput {
  State state;
};

using SimulationInput = std::variant<WrenchInput, ClearInput, StateInput, ResetInput, CommandInput,
                                     LoadInput, WindInput, MassInput, PresenceInput>;

}  // namespace rigid_body_sim
