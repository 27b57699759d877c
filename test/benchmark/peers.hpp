#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Engines that take the same cases as ours. Each registers itself from its own file, so that those
/// that are not installed are simply not there. No Eigen here: odeint's file is compiled for
/// another instruction set, and inline functions of both would be mixed up.
namespace rigid_body_sim::peers {

using Array3 = std::array<double, 3>;
using Quaternion4 = std::array<double, 4>;  // x y z w, unit

/// Where a body is and how it moves, without Eigen.
struct Motion {
  Array3 x_W{};               ///< [m] centre of mass
  Array3 v_W{};               ///< [m/s]
  Quaternion4 q{0, 0, 0, 1};  ///< attitude of the principal axes
  Array3 w_P{};               ///< [rad/s] principal axes
};

/// A force on a body, or a couple.
struct Pull {
  Array3 force_W{};   ///< [N]
  Array3 arm_P{};     ///< [m] where the force acts, seen from the centre of mass
  Array3 torque_W{};  ///< [N m]
};

/// Without damping, from a point of the world to one of the body.
struct SpringToWorld {
  Array3 anchor_W{};       ///< [m]
  Array3 arm_P{};          ///< [m] seen from the centre of mass
  double stiffness = 0;    ///< [N/m]
  double rest_length = 0;  ///< [m]
};

/// Wheels about the three principal axes, discs of no thickness whose centres are the centre of
/// mass; mass and moments of the body are with them. They stand still in it at the start.
struct ReactionWheels {
  struct Command {
    double start = 0;   ///< [s]
    Array3 torque_P{};  ///< [N m] of the motors on the wheels, until the next command
  };
  double mass = 0;                  ///< [kg] of each
  double inertia = 0;               ///< [kg m²] of each about its axis; half of it across
  std::vector<Command> commands{};  ///< by their starts, the first at 0

  double endOf(std::size_t command, double duration) const {
    return command + 1 < commands.size() ? commands[command + 1].start : duration;
  }
};

/// One body under gravity, a constant force, a spring, and pulls; or free, with wheels.
struct Problem {
  const char* name;
  double mass;  ///< [kg]
  Array3 I;     ///< [kg m²]
  Motion start;
  Array3 g_W{};         ///< [m/s²]
  Array3 force_W{};     ///< [N]
  Array3 arm_P{};       ///< [m] where the force acts, fixed in the body
  double duration = 0;  ///< [s]
  Quaternion4 truth{};  ///< attitude at the end

  /// What else acts, asked for in each step, or at every stage where an engine can. Mostly nothing.
  std::function<std::vector<Pull>(const Motion&)> pulls{};

  std::optional<SpringToWorld> spring{};
  std::optional<ReactionWheels> wheels{};

  bool isPushed() const { return force_W != Array3{}; }
};

/// From body axes, whose attitude is q.
inline Array3 inWorldAxes(const Quaternion4& q, const Array3& v) {
  const auto cross = [](const Array3& a, const Array3& b) {
    return Array3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Array3 u{q[0], q[1], q[2]};
  const Array3 t = cross(u, v), s = cross(u, t);
  Array3 turned{};
  for (std::size_t i = 0; i < 3; ++i) turned[i] = v[i] + 2 * (q[3] * t[i] + s[i]);
  return turned;
}

/// The way back.
inline Array3 inBodyAxes(const Quaternion4& q, const Array3& v) {
  return inWorldAxes({-q[0], -q[1], -q[2], q[3]}, v);
}

/// The body without its wheels; of other problems, the body.
inline Problem hubOf(Problem problem) {
  if (!problem.wheels) return problem;
  problem.mass -= 3 * problem.wheels->mass;
  for (double& moment : problem.I) moment -= 2 * problem.wheels->inertia;  // J + J/2 + J/2
  return problem;
}

/// [kg m²] of the wheel about this axis.
inline Array3 wheelMoments(const ReactionWheels& wheels, std::size_t axis) {
  Array3 moments{wheels.inertia / 2, wheels.inertia / 2, wheels.inertia / 2};
  moments[axis] = wheels.inertia;
  return moments;
}

/// What a spring does to a body, as a user of an engine without such a spring writes it.
inline Pull pullOf(const SpringToWorld& spring, const Motion& m) {
  Array3 along = inWorldAxes(m.q, spring.arm_P);
  for (std::size_t i = 0; i < 3; ++i) along[i] += m.x_W[i] - spring.anchor_W[i];
  const double length = std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
  const double per_length = spring.stiffness * (spring.rest_length / length - 1);
  for (double& component : along) component *= per_length;
  return {along, spring.arm_P};
}

/// A run: what it took and where it ended.
struct Run {
  std::string setting;
  double seconds = 0;  ///< of processor time
  Quaternion4 q{};     ///< attitude at the end
};

/// [rad] between the end of a run and the truth; NaN where the run lost the finite numbers.
double errorOf(const Run& run, const Problem& problem);

/// Attitude errors [rad] whose cost is asked for.
constexpr std::array<double, 4> kTargets{1e-2, 1e-4, 1e-6, 1e-9};

/// What an engine can be set to, where the steps are given.
struct Stepper {
  const char* name;
  Motion (*end)(const Problem&, double h, int steps);  ///< h [s]
};

/// Many bodies in one world, the same that an engine's stepper of this name takes through a problem
/// of a single one.
struct Crowd {
  const char* name;
  /// [s] of processor time of so many steps of h, without making the world.
  double (*seconds)(const std::vector<Problem>& bodies, double h, int steps);
};

struct Engine {
  const char* name;
  std::vector<Run> (*runs)(const Problem&);  ///< over ladders of all that it can be set to
  std::vector<Stepper> steppers;             ///< the best of it
  std::vector<Crowd> crowds{};
};

/// All that are linked in.
std::vector<Engine>& engines();

struct Registration {
  explicit Registration(const Engine& engine) { engines().push_back(engine); }
};

std::string label(const std::string& method, const char* what, double value);

}  // namespace rigid_body_sim::peers
