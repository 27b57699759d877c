#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/actuator.hpp>
#include <rigid_body_sim/dynamics/rotation_split.hpp>
#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// What never changes about a rigid body, in the principal frame P: origin at the centre of mass,
/// axes the principal axes. Of a body with wheels, moments and axes are those of I − Σ J a aᵀ: the
/// inertia without what the wheels have about their own axes.
///
/// Of a body on a pivot, a point that stays in place, the origin of P is that point, and I is the
/// inertia about it: with c from the point to the centre of mass,
///   I = I_cm + m (|c|² E − c cᵀ).
struct Body {
  std::string name;
  double mass = 0;                ///< [kg] > 0
  Vector3d I;                     ///< [kg m²] principal moments, ascending
  Vector3d inv_I;                 ///< [1/(kg m²)]
  Isometry3d X_BP;                ///< P in the body frame B that the user knows
  Quaterniond q_BP;               ///< the rotation of X_BP
  RotationSplit<double> split{};  ///< of its free rotation
  bool fixed = false;             ///< never moves; its mass is then ignored
  bool absent = false;            ///< takes no part: nothing acts on it, and it acts on nothing
  std::vector<Actuator> actuators{};
  bool pivoted = false;               ///< whether the origin of P is a pivot
  Vector3d com_P = Vector3d::Zero();  ///< [m] centre of mass; the origin of P without a pivot
};

/// The body of the given mass properties, which include rotors and wheels as if they stood still in
/// it. pivot_B [m]: the point about which it turns without friction; none: it moves freely. Throws
/// std::invalid_argument for what has a fault (massPropertiesFault, actuatorsFault, a pivot that is
/// not finite).
Body makeBody(std::string name, const MassProperties& properties_B,
              std::vector<Actuator> actuators = {},
              const std::optional<Vector3d>& pivot_B = std::nullopt);

/// Whether a body takes part in the motion.
inline bool moves(const Body& body) { return !body.fixed && !body.absent; }

/// The principal frame P of a body as it was, seen from that of the body as it is: X_NP.
Isometry3d frameBefore(const Body& before, const Body& after);

}  // namespace rigid_body_sim
