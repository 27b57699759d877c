#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/contact/feature.hpp"
#include "dynamics/contact/flight_bound.hpp"
#include "support/contact_benches.hpp"

/// Where features touch a plane.
namespace rigid_body_sim {
namespace {

struct Placed {
  Quaterniond q_WP;
  Vector3d n_W;
};

Vector3d anyVector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

Placed anyPlace(std::mt19937& random) {
  return {rotationExp(anyVector(random)), anyVector(random).normalized()};
}

/// The least n · r of points of a surface.
template <class Point>
double lowestOf(const Placed& at, const Point& point) {
  double least = 1e300;
  for (int i = 0; i <= 400; ++i)
    for (int j = 0; j < 800; ++j)
      least = std::min(least, at.n_W.dot(rotate(at.q_WP, point(M_PI * i / 400, M_PI * j / 400))));
  return least;
}

TEST(Features, TouchAtTheDeepestPointOfAnEllipsoid) {
  std::mt19937 random(30);
  ContactShape shape;
  shape.ellipsoids.push_back(
      {{0.1, -0.2, 0.05}, rotationExp(Vector3d(0.3, 1, -0.4)), {0.3, 0.2, 0.1}});
  const ContactShape::Ellipsoid& e = shape.ellipsoids[0];
  const Feature feature = featuresOf(shape, "body").front();
  for (int i = 0; i < 5; ++i) {
    const Placed at = anyPlace(random);
    const PlanePoints points = planePoints(feature, at.q_WP, at.n_W);
    const double lowest = lowestOf(at, [&](double polar, double azimuth) {
      const Vector3d unit(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                          std::cos(polar));
      return Vector3d(e.center_P + rotate(e.q_PE, Vector3d(e.semi_axes.cwiseProduct(unit))));
    });
    EXPECT_NEAR(points.height[0], lowest, 1e-5);
    EXPECT_LE(points.height[0], lowest + 1e-15);
    EXPECT_NEAR(at.n_W.dot(points.arm_W[0]), points.height[0], 1e-15);
    // it lies on the ellipsoid
    const Vector3d r_E =
        rotateBack(e.q_PE, Vector3d(rotateBack(at.q_WP, points.arm_W[0]) - e.center_P));
    EXPECT_NEAR(r_E.cwiseQuotient(e.semi_axes).norm(), 1, 1e-14);
  }
}

TEST(Features, TouchAtTheLowestPointOfARimAndThreeMore) {
  std::mt19937 random(31);
  ContactShape shape;
  shape.rims.push_back({{0.1, 0, 0.3}, {0, 3, 4}, 0.25});
  const Feature feature = featuresOf(shape, "body").front();
  for (int i = 0; i < 5; ++i) {
    const Placed at = anyPlace(random);
    const PlanePoints points = planePoints(feature, at.q_WP, at.n_W);
    const Vector3d a(0, 0.6, 0.8), x(1, 0, 0), y = a.cross(x);
    const double lowest = lowestOf(at, [&](double, double azimuth) {
      return Vector3d(Vector3d(0.1, 0, 0.3) +
                      0.25 * (std::cos(azimuth) * x + std::sin(azimuth) * y));
    });
    EXPECT_NEAR(points.height[0], lowest, 1e-5);
    EXPECT_LE(points.height[0], lowest + 1e-15);
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(at.n_W.dot(points.arm_W[j]), points.height[j], 1e-15);
      const Vector3d from_center = rotateBack(at.q_WP, points.arm_W[j]) - Vector3d(0.1, 0, 0.3);
      EXPECT_NEAR(from_center.norm(), 0.25, 1e-15);
      EXPECT_NEAR(from_center.dot(a), 0, 1e-15);
    }
    EXPECT_NEAR(points.height[0] + points.height[3], points.height[1] + points.height[2], 1e-15);
  }
}

TEST(Features, LieFlatOnARimThatHasNoLowestPoint) {
  ContactShape shape;
  shape.rims.push_back({Vector3d::Zero(), Vector3d::UnitZ(), 0.25});
  const Feature feature = featuresOf(shape, "body").front();
  const PlanePoints points =
      planePoints(feature, Quaterniond::Identity(), Vector3d(Vector3d::UnitZ()));
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_EQ(points.height[j], 0);
    EXPECT_NEAR(points.arm_W[j].norm(), 0.25, 1e-16);
  }
}

// h(m) is the greatest x · m; the lowest point towards n has n · r = −h(−n).
TEST(Features, HaveTheSupportOfTheirLowestPoints) {
  std::mt19937 random(32);
  ContactShape shape;
  shape.points.push_back({0.3, 0.1, -0.2});
  shape.balls.push_back({{0.1, 0.2, 0.3}, 0.15});
  shape.ellipsoids.push_back({{0.1, -0.2, 0}, rotationExp(Vector3d(1, 0, 0)), {0.3, 0.2, 0.1}});
  shape.rims.push_back({{0, 0, 0.3}, {1, 2, 3}, 0.25});
  for (const Feature& feature : featuresOf(shape, "body")) {
    const Placed at = anyPlace(random);
    const Vector3d m_P = -rotateBack(at.q_WP, at.n_W);
    EXPECT_NEAR(support(feature, m_P), -planePoints(feature, at.q_WP, at.n_W).height[0], 1e-15);
    EXPECT_NEAR(support(feature, Vector3d(2.5 * m_P)), 2.5 * support(feature, m_P), 1e-15);
  }
}

// Along free flights, no feature is ever nearer than the bound says.
TEST(FlightBound, IsNeverAboveTheGap) {
  std::mt19937 random(33);
  const Vector3d size(0.2, 0.4, 0.7);
  ContactShape shape;
  shape.points.push_back({0.3, 0.1, -0.2});
  shape.rims.push_back({{0, 0, 0.3}, {1, 2, 3}, 0.25});
  for (int i = 0; i < 100; ++i) {
    test::Bench bench;
    bench.world.g_W = {0, 0, -9.81};
    bench.add(makeBody("body", massProperties(Box{size}, 2)),
              test::motionAt({0, 0, 0.8}, anyVector(random), 4 * anyVector(random)));
    const Body& body = bench.world.bodies[0];
    MotionBound bound;
    bound.a_W = bench.world.g_W;
    const HalfSpace plane;
    const PlaneFlight flight(body, bench.initial.bodies[0], plane, bound);
    for (const Feature& feature : featuresOf(shape, "body")) {
      const double clear = flight.clearFor(feature);
      EXPECT_GT(clear, 0);
      Simulation sim = bench.simulation("auto", 1);
      for (int k = 1; k <= 20; ++k) {
        const BodyState s = sim.sample(std::min(clear, 1.0) * k / 20).bodies[0];
        const double gap = s.x_W.z() + planePoints(feature, s.q_WP, Vector3d(0, 0, 1)).height[0];
        EXPECT_GT(gap, -1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace rigid_body_sim
