#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/point_wrench.hpp>
#include <rigid_body_sim/math/rotation.hpp>

namespace rigid_body_sim {

/// What changes about a body, in momentum form. T: the scalar.
///
/// The angular momentum is carried twice, in world and in principal axes, because each keeps what
/// the other loses: L_W is constant to the last bit without torque; L_P gives the angular velocity
/// of a needle, whose small component would drown in the rounding of R(q_WP)ᵀ L_W.
///
/// Of a body with wheels and rotors, L_W includes their angular momentum H and L_P does not:
///   L_W = R(q_WP) (L_P + H),   L_P = I ω
///
/// Of a body on a pivot the state is its rotation: x is where the pivot is, p is zero, L is about
/// the pivot.
template <class T>
struct BodyStateT {
  Vector3<T> x_W = Vector3<T>::Zero();  ///< [m] origin of P: the centre of mass, or the pivot
  Vector3<T> x_low_W =
      Vector3<T>::Zero();  ///< [m] what x_W is too coarse to hold: position = x_W + x_low_W
  Quaternion<T> q_WP = Quaternion<T>::Identity();  ///< attitude of the principal axes, unit
  Vector3<T> p_W = Vector3<T>::Zero();             ///< [kg m/s] momentum
  Vector3<T> L_W = Vector3<T>::Zero();  ///< [kg m²/s] angular momentum about the origin of P
  Vector3<T> L_P = Vector3<T>::Zero();  ///< [kg m²/s] I ω, the same in principal axes
};
using BodyState = BodyStateT<double>;

/// Where the present piece of a body's solved motion starts: it is evaluated from there at any
/// time.
struct MotionAnchor {
  double t = 0;     ///< [s]
  BodyState state;  ///< at t
  /// [s] When something starts or ends next, as it was known when the motion was anchored; −∞ where
  /// it is integrated, or has not been solved since the last event.
  double horizon = std::numeric_limits<double>::infinity();
};

/// How bodies that act on one another are advanced together.
struct MotionPlan {
  std::vector<std::size_t> bodies;  ///< indices, ascending
  /// Indices in World::laws, ascending: of those that act between them, and of contacts and
  /// tethers between them that may begin to.
  std::vector<std::size_t> laws, waiting_laws;
  std::string integrator;     ///< a name of the catalogue; empty: the motion is solved
  int substeps = 1;           ///< equal substeps of each time step, at least
  bool by_estimates = false;  ///< the integrator's own error estimates divide its steps further
  bool at_rest = false;  ///< bodies in contact that have come to rest, until they are disturbed
  bool holds = true;     ///< with auto: whether an integrator was found to hold the tolerance
  double error = 0;      ///< with auto: what the trial found, as a share of the tolerance
  /// [s] With auto: up to when the motion was tried; then the error estimates take over. Infinite
  /// where it was not.
  double tried_until = std::numeric_limits<double>::infinity();
  bool cut_short = false;        ///< whether the trial ended before the world's horizon
  std::int64_t evaluations = 0;  ///< of all its wrenches, so far
};

/// A wrench that acts on a body or is to come, and its slot; see WrenchInput.
struct ScheduledWrench {
  std::string slot;
  PointWrench wrench;
};

/// What wrenches and commands do to one body from now on.
struct BodySchedule {
  std::vector<ScheduledWrench> wrenches;  ///< that act, in the order in which they began; to come
  std::vector<ActuatorCommand> commands;  ///< to come
};

/// What a run has changed about a body of its world.
struct BodyChange {
  std::optional<MassProperties> properties_B;  ///< in place of the world's; see MassInput
  std::optional<bool> absent;                  ///< likewise

  bool any() const { return properties_B || absent; }
};
bool operator==(const BodyChange& a, const BodyChange& b);

/// What changes about the world, and what it takes to go on from there.
struct State {
  double t = 0;  ///< [s] since the start of the simulation
  /// In the order of World::bodies. Who changes one, or t, clears `anchors` and `plans`: a solved
  /// motion goes on from its anchor, and a state elsewhere than that leads is refused.
  std::vector<BodyState> bodies;
  /// Of the laws that have states of their own, law by law in the order of World::laws; empty: as
  /// they start.
  std::vector<double> laws{};
  /// Of the actuators, body by body in the order of Body::actuators; empty: as they start, and L_W
  /// then gains what wheels and rotors have.
  std::vector<std::vector<ActuatorState>> actuators{};
  /// Body by body; empty: the wrenches of the world, and those of its commands that the state has
  /// not taken yet.
  std::vector<BodySchedule> schedules{};
  /// Body by body, against the world as it was made; empty: nothing is changed. Momenta and
  /// principal axes of this state are those of the bodies with their changes.
  std::vector<BodyChange> changes{};
  /// What the same bits need beside: the anchors, one a body, the plans, and the contacts that link
  /// bodies because these are near each other. Empty in a state that a program makes: then motions
  /// are anchored at it, and auto chooses anew.
  std::vector<MotionAnchor> anchors{};
  std::vector<MotionPlan> plans{};
  std::vector<std::size_t> near_laws{};  ///< indices in World::laws, ascending
  /// With contacts or tethers: ContactTrial::step_bound; 0: chosen anew.
  double contact_bound = 0;
};

/// Pose and velocity of a body frame, as its user gives and reads them.
struct BodyFrameMotion {
  Vector3d x_W = Vector3d::Zero();             ///< [m] origin of B
  Quaterniond q_WB = Quaterniond::Identity();  ///< attitude of B
  Vector3d v_W = Vector3d::Zero();             ///< [m/s] velocity of the origin of B, world axes
  Vector3d w_W = Vector3d::Zero();             ///< [rad/s] angular velocity, world axes
};

/// ω = I⁻¹ L in principal axes [rad/s].
template <class T>
Vector3<T> angularVelocity(const Vector3<T>& inv_I, const Vector3<T>& L_P) {
  return inv_I.cwiseProduct(L_P);
}

/// State of the origin of P from the motion of the body frame, with r from the one to the other:
///   x = x_B + R r,  v = v_B + ω × R r,  p = m v,  L = I ω.
/// L_W lacks what wheels and rotors have; a simulation that takes the state over adds it. Of a body
/// on a pivot p = 0, whatever v_B is.
BodyState toBodyState(const Body& body, const BodyFrameMotion& motion);

/// The inverse of toBodyState; velocities v_B = v − ω × R r.
BodyFrameMotion toBodyFrameMotion(const Body& body, const BodyState& state);

/// What the actuators of a body do at the time of a state that a simulation gave. Throws
/// std::invalid_argument where State::actuators has none of this body.
std::vector<ActuatorReading> readActuators(const Body& body, const State& state, std::size_t index);

/// [m] From one state of a body to another, the low parts of the positions included.
double distanceBetween(const BodyState& a, const BodyState& b);

/// [m] Where the centre of mass is: x + R c.
Vector3d centerOfMass(const Body& body, const BodyState& state);

/// [kg m/s] Momentum of the body, m v of its centre of mass: p, and on a pivot m ω × R c.
Vector3d momentumOf(const Body& body, const BodyState& state);

/// [m] √(I_max/m), a length of the order of the body's size.
double radiusOfGyration(const Body& body);

/// ½ p²/m + ½ Σ Lᵢ²/Iᵢ  [J]; of a body on a pivot the second is all it has.
double kineticEnergy(const Body& body, const BodyState& state);

}  // namespace rigid_body_sim
