#include <array>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/particles.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

#include "support/mass_difference.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

/// One of each, all different in every size.
const std::array<Shape, 6> kShapes{Box{{0.3, 0.5, 0.9}},       Sphere{0.7},
                                   Cylinder{0.4, 1.1},         Capsule{0.4, 0.9},
                                   Ellipsoid{{0.3, 0.5, 0.8}}, Cone{0.5, 1.2}};

/// Radius of a solid of revolution at height z; negative outside.
double radiusAt(const Cylinder& c, double z) { return std::abs(z) < c.length / 2 ? c.radius : -1; }
double radiusAt(const Cone& c, double z) { return c.radius * (0.75 - z / c.length); }
double radiusAt(const Capsule& c, double z) {
  const double into_cap = std::max(0.0, std::abs(z) - c.length / 2);
  return into_cap < c.radius ? std::sqrt(c.radius * c.radius - into_cap * into_cap) : -1;
}

/// Whether the point lies within the solid, by its definition.
bool contains(const Box& b, const Vector3d& p) {
  return ((2 * p).cwiseAbs() - b.size).maxCoeff() < 0;
}
bool contains(const Sphere& s, const Vector3d& p) { return p.norm() < s.radius; }
bool contains(const Ellipsoid& e, const Vector3d& p) {
  return p.cwiseQuotient(e.semi_axes).norm() < 1;
}
bool contains(const Cylinder& c, const Vector3d& p) {
  return p.head<2>().norm() < radiusAt(c, p.z());
}
bool contains(const Capsule& c, const Vector3d& p) {
  return p.head<2>().norm() < radiusAt(c, p.z());
}
bool contains(const Cone& c, const Vector3d& p) {
  return p.z() > -c.length / 4 && p.head<2>().norm() < radiusAt(c, p.z());
}

/// The solid of density 1 as particles in the middle of the cells of a grid of n³ over ±1, which is
/// turned, so that no face or axis of the solid lies along it and the cut cells average out.
MassProperties integratedOverGrid(const Shape& shape, int n) {
  Particles cells;
  const double h = 2.0 / n;
  const Matrix3d R = Eigen::AngleAxisd(1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vector3d p = R * (h * Vector3d(i + 0.5, j + 0.5, k + 0.5) - Vector3d::Ones());
        if (!std::visit([&](const auto& s) { return contains(s, p); }, shape)) continue;
        cells.push_back({h * h * h, p, Vector3d::Zero()});
      }
  return massProperties(cells);
}

}  // namespace

TEST(Shapes, HaveTheClosedFormsOfTheLecture) {
  const MassProperties box = massProperties(Box{{1, 2, 3}}, 12);
  EXPECT_EQ(box.I_Bcm, Matrix3d(Vector3d(4 + 9, 1 + 9, 1 + 4).asDiagonal()));
  const MassProperties sphere = massProperties(Sphere{2}, 5);
  EXPECT_EQ(sphere.I_Bcm, Matrix3d(8 * Matrix3d::Identity()));
  EXPECT_EQ(volume(Box{{1, 2, 3}}), 6);
  EXPECT_DOUBLE_EQ(volume(Sphere{2}), 32 * M_PI / 3);
}

TEST(Shapes, AgreeWithANumericalIntegral) {
  for (const Shape& shape : kShapes) {
    SCOPED_TRACE(shape.index());
    // 3.2e-3 measured for the sphere, whose symmetry the grid shares; 2e-3 and less for the others
    EXPECT_TRUE(sameMass(integratedOverGrid(shape, 100), ofDensityOne(shape), 4e-3));
  }
}

TEST(Shapes, AreTheLimitOfTheirTriangulations) {
  for (const Shape& shape : kShapes) {
    SCOPED_TRACE(shape.index());
    const MassProperties exact = ofDensityOne(shape);
    if (std::holds_alternative<Box>(shape)) {
      EXPECT_TRUE(sameMass(ofDensityOne(triangulated(shape, 0)), exact, 1e-15));
      continue;
    }
    const MassProperties coarse = ofDensityOne(triangulated(shape, 64));
    const MassProperties fine = ofDensityOne(triangulated(shape, 128));
    // second order: half the mesh width, a quarter of the error, 4.00 ± 0.02 measured …
    EXPECT_NEAR(massDifference(coarse, exact) / massDifference(fine, exact), 4, 0.03);
    // … so that Richardson's extrapolation leaves the fourth order
    const MassProperties extrapolated{fine.mass + (fine.mass - coarse.mass) / 3,
                                      fine.com_B + (fine.com_B - coarse.com_B) / 3,
                                      fine.I_Bcm + (fine.I_Bcm - coarse.I_Bcm) / 3};
    EXPECT_TRUE(sameMass(extrapolated, exact, 1e-5));
  }
}

TEST(Shapes, MeetWhereOneBecomesAnother) {
  EXPECT_TRUE(sameMass(ofDensityOne(Capsule{0.7, 0}), ofDensityOne(Sphere{0.7}), 1e-15));
  EXPECT_TRUE(sameMass(ofDensityOne(Ellipsoid{{0.7, 0.7, 0.7}}), ofDensityOne(Sphere{0.7}), 1e-15));
  // a long capsule is a cylinder: caps of 4/3 r/l of its mass, three times that of its inertia
  EXPECT_TRUE(
      sameMass(massProperties(Capsule{1e-9, 1}, 1), massProperties(Cylinder{1e-9, 1}, 1), 1e-8));
}

TEST(Shapes, OfACapsuleAreACylinderAndTwoHalfSpheres) {
  // the caps by the lecture's parallel axes; a half sphere: com 3/8 r, I = 83/320 m r² across
  const double r = 0.4, l = 0.9;
  const double m_cap = volume(Sphere{r}) / 2;
  const double across = 83.0 / 320.0 * m_cap * r * r, along = 2.0 / 5.0 * m_cap * r * r;
  MassProperties cap{m_cap, {0, 0, l / 2 + 3.0 / 8.0 * r}, Matrix3d::Zero()};
  cap.I_Bcm.diagonal() << across, across, along;
  MassProperties lower = cap;
  lower.com_B *= -1;
  EXPECT_TRUE(sameMass(combined({ofDensityOne(Cylinder{r, l}), cap, lower}),
                       ofDensityOne(Capsule{r, l}), 1e-15));
}

TEST(Shapes, ScaleAsTheCubeAndTheFifthPower) {
  for (const double s : {0.25, 8.0}) {  // powers of two: exact
    EXPECT_EQ(volume(Cone{0.5 * s, 1.2 * s}), s * s * s * volume(Cone{0.5, 1.2}));
    const MassProperties small = ofDensityOne(Capsule{0.4, 0.9});
    const MassProperties large = ofDensityOne(Capsule{0.4 * s, 0.9 * s});
    EXPECT_DOUBLE_EQ(large.mass, std::pow(s, 3) * small.mass);
    EXPECT_LE((large.I_Bcm - std::pow(s, 5) * small.I_Bcm).norm(), 1e-15 * large.I_Bcm.norm());
  }
}

TEST(Shapes, AreFreeOfFaults) {
  for (const Shape& shape : kShapes) EXPECT_EQ(massPropertiesFault(massProperties(shape, 2)), "");
  EXPECT_EQ(massPropertiesFault(massProperties(Box{{1, 1, 1e-7}}, 1)), "");
  EXPECT_EQ(massPropertiesFault(massProperties(Cylinder{5e-7, 1}, 1)), "");
}

TEST(Shapes, HaveLengthsGreaterThanZero) {
  const double nan = std::nan("");
  for (const Shape& shape :
       {Shape(Box{{0.1, -0.4, 0.9}}), Shape(Box{{0.1, 0.4, nan}}), Shape(Sphere{0}),
        Shape(Cylinder{0.1, -1}), Shape(Cylinder{-0.1, 1}), Shape(Capsule{0.1, -0.1}),
        Shape(Capsule{0, 0.1}), Shape(Ellipsoid{{1, 0, 1}}), Shape(Cone{0.1, nan})})
    EXPECT_THROW(massProperties(shape, 1), std::invalid_argument) << shape.index();
  EXPECT_NO_THROW(massProperties(Capsule{0.1, 0}, 1));
}

}  // namespace rigid_body_sim
