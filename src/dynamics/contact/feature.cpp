#include "dynamics/contact/feature.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid_body_sim {
namespace {

void requireOfShape(bool holds, const std::string& body, const char* rule) {
  if (!holds) throw std::invalid_argument("contact of body '" + body + "': " + rule);
}

bool isPositiveLength(double x) { return x > 0 && std::isfinite(x); }

/// The four points of a rim. Its depth as a function of the tilt has a kink where the rim lies
/// flat; the sum over an even number of points has none. Those beside the lowest stay as deep as
/// the centre, however the body spins: with the rate of the body's material there, a spin would be
/// fed into the tilt, as by the damping inside of a rotor.
PlanePoints rimPoints(const Feature& rim, const Quaterniond& q_WP, const Vector3d& n_W) {
  const Vector3d a = rotate(q_WP, rim.axis_P), c = rotate(q_WP, rim.center_P);
  Vector3d down = n_W.dot(a) * a - n_W;
  const double tilt = down.norm();
  down = tilt > 0 ? Vector3d(down / tilt) : Vector3d(a.unitOrthogonal());
  const Vector3d side = a.cross(down);
  const double R = rim.radius, height = n_W.dot(c);
  return {{c + R * down, c + R * side, c - R * side, c - R * down},
          {height - R * tilt, height, height, height + R * tilt},
          {c + R * down, c, c, c - R * down}};
}

}  // namespace

double Feature::size() const { return kind == Kind::kEllipsoid ? semi_axes.maxCoeff() : radius; }

std::vector<Feature> featuresOf(const ContactShape& shape, const std::string& body) {
  std::vector<Feature> features;
  for (const Vector3d& point : shape.points) {
    features.emplace_back();
    features.back().center_P = point;
  }
  for (const ContactShape::Ball& ball : shape.balls) {
    requireOfShape(isPositiveLength(ball.radius), body, "the radius of a ball must be > 0 m");
    features.emplace_back();
    features.back().kind = Feature::Kind::kBall;
    features.back().center_P = ball.center_P;
    features.back().radius = ball.radius;
  }
  for (const ContactShape::Ellipsoid& ellipsoid : shape.ellipsoids) {
    requireOfShape((ellipsoid.semi_axes.array() > 0).all() && ellipsoid.semi_axes.allFinite(), body,
                   "the semi-axes of an ellipsoid must be > 0 m");
    requireOfShape(isNearlyUnit(ellipsoid.q_PE), body, "the attitude of an ellipsoid must be unit");
    features.emplace_back();
    features.back().kind = Feature::Kind::kEllipsoid;
    features.back().center_P = ellipsoid.center_P;
    features.back().q_PE = ellipsoid.q_PE;
    features.back().semi_axes = ellipsoid.semi_axes;
  }
  for (const ContactShape::Rim& rim : shape.rims) {
    requireOfShape(isPositiveLength(rim.radius), body, "the radius of a rim must be > 0 m");
    requireOfShape(isPositiveLength(rim.axis_P.norm()), body, "the axis of a rim must not be zero");
    features.emplace_back();
    features.back().kind = Feature::Kind::kRim;
    features.back().center_P = rim.center_P;
    features.back().axis_P = rim.axis_P.normalized();
    features.back().radius = rim.radius;
  }
  for (const Feature& feature : features)
    requireOfShape(feature.center_P.allFinite(), body, "places of its shape must be finite");
  return features;
}

Feature moved(Feature feature, const Isometry3d& X_NP) {
  feature.center_P = X_NP * feature.center_P;
  feature.axis_P = X_NP.linear() * feature.axis_P;
  feature.q_PE = (Quaterniond(X_NP.linear()) * feature.q_PE).normalized();
  return feature;
}

PlanePoints planePoints(const Feature& feature, const Quaterniond& q_WP, const Vector3d& n_W) {
  const Vector3d c = rotate(q_WP, feature.center_P);
  PlanePoints points;
  points.arm_W[0] = c;
  switch (feature.kind) {
    case Feature::Kind::kPoint:
      points.height[0] = n_W.dot(c);
      break;
    case Feature::Kind::kBall:
      points.arm_W[0] = c - feature.radius * n_W;
      points.height[0] = n_W.dot(c) - feature.radius;
      break;
    case Feature::Kind::kEllipsoid: {
      const Quaterniond q_WE = product(q_WP, feature.q_PE);
      const Vector3d Dm = feature.semi_axes.cwiseProduct(rotateBack(q_WE, n_W));
      const Vector3d down_E = feature.semi_axes.cwiseProduct(Dm / -Dm.norm());
      points.arm_W[0] = c + rotate(q_WE, down_E);
      points.height[0] = n_W.dot(c) - Dm.norm();
      break;
    }
    case Feature::Kind::kRim:
      return rimPoints(feature, q_WP, n_W);
  }
  points.rate_arm_W[0] = points.arm_W[0];
  return points;
}

double support(const Feature& feature, const Vector3d& m_P) {
  const double of_center = feature.center_P.dot(m_P);
  switch (feature.kind) {
    case Feature::Kind::kPoint:
      break;
    case Feature::Kind::kBall:
      return of_center + feature.radius * m_P.norm();
    case Feature::Kind::kEllipsoid:
      return of_center + feature.semi_axes.cwiseProduct(rotateBack(feature.q_PE, m_P)).norm();
    case Feature::Kind::kRim:
      return of_center + feature.radius * feature.axis_P.cross(m_P).norm();
  }
  return of_center;
}

}  // namespace rigid_body_sim
