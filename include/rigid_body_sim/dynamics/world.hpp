#pragma once

#include <memory>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>
#include <rigid_body_sim/dynamics/imu.hpp>

namespace rigid_body_sim {

/// How the motion is to be computed.
struct SolverOptions {
  static constexpr int kMaxThreads = 1024;

  std::string integrator = "auto";  ///< a name of the catalogue
  double time_step = 1e-3;          ///< [s] > 0
  double tolerance = 1e-9;          ///< with auto: bound on the attitude error [rad] and on the
                                    ///< position error relative to the path length, over horizon
  double horizon = 10;              ///< [s]
  bool tolerance_stated = false;    ///< with auto: whether motions that can be solved need no more
                                    ///< than the tolerance; else they are solved to rounding
  int threads = 1;  ///< at most so many step and read bodies in packs; the same bits
                    ///< for any number
};

/// What of a world depends on the mass properties of its bodies.
struct WorldBodies {
  std::vector<Body> bodies;
  std::vector<PointWrench> wrenches;
  ForceLaws laws;
};

/// Everything that stays constant in a simulation: what the scene names and nothing else.
struct World {
  std::vector<Body> bodies;
  Vector3d g_W = Vector3d::Zero();        ///< [m/s²] uniform gravity
  std::vector<PointWrench> wrenches;      ///< scheduled by the scene; times from the start
  std::vector<ActuatorCommand> commands;  ///< likewise
  ForceLaws laws;                         ///< between bodies, points and the world
  bool has_medium = false;  ///< whether a medium is named, the velocity of which may be set
  /// Central gravity, for IMUs on fixed bodies; on bodies that move it is a law.
  std::vector<GravityCenter> gravity_centers;
  std::vector<Imu> imus;  ///< body by body
  SolverOptions solver;
  /// Tells worlds of different scenes apart, so that none takes the saved state of another; empty
  /// in a world that a program makes.
  std::string fingerprint;
  /// Of a world with changes: what it was without; null where there are none.
  std::shared_ptr<const WorldBodies> unchanged{};
};

/// The world with these changes, and no others; see State::changes. Throws std::invalid_argument,
/// naming the body, where a body that is fixed is changed, where mass properties break a rule of
/// makeBody, and where a law does not follow.
World withChanges(World world, const std::vector<BodyChange>& changes);

/// Kinetic energy of the bodies that move, with their wheels and rotors, and potential energy of
/// gravity and of the laws [J]. Throws std::invalid_argument as totalsOf does.
double mechanicalEnergy(const World& world, const State& state);

}  // namespace rigid_body_sim
