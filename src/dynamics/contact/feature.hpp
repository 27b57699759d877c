#pragma once

#include <array>
#include <vector>

#include <rigid_body_sim/dynamics/contact.hpp>

namespace rigid_body_sim {

/// A feature of a ContactShape, of any kind.
struct Feature {
  enum class Kind { kPoint, kBall, kEllipsoid, kRim };
  Kind kind = Kind::kPoint;
  Vector3d center_P = Vector3d::Zero();        ///< [m]
  double radius = 0;                           ///< [m] of a ball or a rim
  Vector3d axis_P = Vector3d::UnitZ();         ///< of a rim
  Quaterniond q_PE = Quaterniond::Identity();  ///< of an ellipsoid
  Vector3d semi_axes = Vector3d::Zero();       ///< [m] of an ellipsoid

  /// At how many points it touches a plane.
  std::size_t pointCount() const { return kind == Kind::kRim ? 4 : 1; }

  /// [m] Its greatest size about its centre.
  double size() const;

  /// [m] A bound on the distance of its points from the centre of mass.
  double reach() const { return center_P.norm() + size(); }
};

/// The features in the order points, balls, ellipsoids, rims. Throws std::invalid_argument for one
/// that breaks a rule, with `body` in the message.
std::vector<Feature> featuresOf(const ContactShape& shape, const std::string& body);

/// The same feature in another frame N of the body.
Feature moved(Feature feature, const Isometry3d& X_NP);

/// Where a feature touches a plane: its deepest point; of a rim the lowest, the two beside, and the
/// highest.
struct PlanePoints {
  std::array<Vector3d, 4> arm_W;       ///< [m] from the centre of mass
  std::array<double, 4> height;        ///< [m] n · arm, without the rounding of the product
  std::array<Vector3d, 4> rate_arm_W;  ///< [m] of a point of the body that sinks as fast as it
};

/// n_W: the normal of the plane, unit.
PlanePoints planePoints(const Feature& feature, const Quaterniond& q_WP, const Vector3d& n_W);

/// [m] The support function of a feature: the greatest x · m of its points x, for any m.
double support(const Feature& feature, const Vector3d& m_P);

}  // namespace rigid_body_sim
