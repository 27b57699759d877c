#pragma once

#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Where a body touches others: its features, in the body's principal frame P, whose origin is the
/// centre of mass (a body on a pivot cannot touch). A feature acts by itself, as if the others were
/// not there.
struct ContactShape {
  /// A ball, or the end of a capsule.
  struct Ball {
    Vector3d center_P = Vector3d::Zero();  ///< [m]
    double radius = 0;                     ///< [m] > 0
  };
  struct Ellipsoid {
    Vector3d center_P = Vector3d::Zero();        ///< [m]
    Quaterniond q_PE = Quaterniond::Identity();  ///< attitude of its axes in P
    Vector3d semi_axes = Vector3d::Zero();       ///< [m] > 0
  };
  /// The circular edge of a cylinder or a cone.
  struct Rim {
    Vector3d center_P = Vector3d::Zero();  ///< [m]
    Vector3d axis_P = Vector3d::UnitZ();   ///< unit
    double radius = 0;                     ///< [m] > 0
  };

  std::vector<Vector3d> points;  ///< [m] corners, vertices of a convex hull, particles, an apex
  std::vector<Ball> balls;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Rim> rims;

  bool empty() const {
    return points.empty() && balls.empty() && ellipsoids.empty() && rims.empty();
  }
};

/// Solid below its plane, free above; it never moves.
struct HalfSpace {
  std::size_t body = kWorld;             ///< the fixed body that it belongs to, or the world
  Vector3d origin_W = Vector3d::Zero();  ///< [m] a point of the plane
  Quaterniond q_WH =
      Quaterniond::Identity();  ///< z: the normal, out of the solid; x, y: in the plane
};

/// Constants of the law, see contactWithHalfSpace.
struct ContactParameters {
  double stiffness = 0;         ///< k [N/m^p] > 0
  double exponent = 1.5;        ///< p >= 1
  double dissipation = 0;       ///< d [s/m] >= 0
  double friction = 0;          ///< μ >= 0
  double breakaway = 1e-5;      ///< b [m] > 0
  double rolling_friction = 0;  ///< ρ [m] >= 0; against half-spaces only
};

/// The dissipation d [s/m] with which a body that strikes at the speed v [m/s] rebounds at e v, for
/// any stiffness, exponent and mass, and without gravity: x = d v solves
///   x (1 + e) = ln((1 + x)/(1 − e x)).
/// Throws std::invalid_argument unless 0 < e <= 1 and v > 0 (e = 0 would need d = ∞), and where d
/// is beyond numbers.
double dissipationForRestitution(double restitution, double approach_speed);

/// Contact of a body that moves with a half-space. Each feature touches at its deepest point; with
/// δ the depth of a point, δ' its rate, and n the normal,
///   N = k δᵖ max(0, 1 + d δ')                                 (Hunt & Crossley, 1975)
/// acts along n. Against the velocity v_t along the plane of the body's material there, a spring
/// and a damper in parallel act in series with a Coulomb slider; with s their stretch,
///   q = k_t s + c_t v_t
///   sticks while |q| <= μ N:   force −q,          s' = v_t
///   slips otherwise:           force −μ N q/|q|,  s' = v_t − (1 − μ N/|q|) q/c_t
///   k_t = μ m g₀/b,   c_t = 0.4 √(k_t m),   g₀ = 9.80665 m/s²
/// so that the spring yields by b under the body's weight on Earth before it slips. s starts from
/// zero at each touch. Rolling friction is the same element on the turning about the axes of the
/// plane, of at most ρ N. Touch, release, the end of N, stick and slip are events.
///
/// A rim acts at four points that turn with its tilt, so that it can stand flat; friction at their
/// centre of pressure, and, about the normal, on the turning of the rim.
///
/// plane.body may be kWorld. Throws std::invalid_argument for parameters or a shape that break a
/// rule.
std::shared_ptr<const ForceLaw> contactWithHalfSpace(const std::vector<Body>& bodies,
                                                     std::size_t body, const ContactShape& shape,
                                                     const HalfSpace& plane,
                                                     const ContactParameters& parameters);

/// Contact of two bodies made of balls, each ball of one with each of the other, by the same law; m
/// in it is m₁ m₂/(m₁ + m₂). The force acts at one point, half way through the overlap, so that
/// angular momentum is conserved. b may be a fixed body: then its balls are given in the world, and
/// m is that of a. Throws std::invalid_argument where a shape has features other than balls.
std::shared_ptr<const ForceLaw> contactOfBalls(const std::vector<Body>& bodies, std::size_t a,
                                               const ContactShape& shape_a, std::size_t b,
                                               const ContactShape& shape_b,
                                               const ContactParameters& parameters);

}  // namespace rigid_body_sim
