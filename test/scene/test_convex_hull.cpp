#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/meshes/bounding_box.hpp"
#include "scene/meshes/convex_hull.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/random_mass.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A hull that is closed and oriented outwards as it is.
TriangleMesh hullOf(const std::vector<Vector3d>& points, double thickness = 0) {
  TriangleMesh hull = convexHull(points, thickness);
  const CheckedMesh checked = checkedMesh(hull);
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(checked.notices, IsEmpty());
  return hull;
}

std::string refusal(const std::vector<Vector3d>& points, double thickness) {
  try {
    convexHull(points, thickness);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "a hull";
}

std::vector<Vector3d> cornersOf(const Vector3d& size) {
  return triangulated(Box{size}, 0).vertices;
}

std::vector<Vector3d> moved(const Isometry3d& X, std::vector<Vector3d> points) {
  for (Vector3d& p : points) p = X * p;
  return points;
}

}  // namespace

TEST(ConvexHull, OfABoxIsTheBoxWhateverLiesWithinIt) {
  RandomMass random(71);
  for (int i = 0; i < 20; ++i) {
    const Vector3d size(random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2));
    std::vector<Vector3d> points = cornersOf(size);
    for (int k = 0; k < 200; ++k) points.push_back(random.vector(0.5).cwiseProduct(size));
    const Isometry3d X = random.isometry(3);
    const TriangleMesh hull = hullOf(moved(X, points));
    EXPECT_EQ(hull.vertices.size(), 8u);
    EXPECT_NEAR(volume(hull), size.prod(), 1e-14);
    EXPECT_TRUE(
        sameMass(massProperties(hull, 2), transformed(X, massProperties(Box{size}, 2)), 1e-13));
  }
}

TEST(ConvexHull, HasTheMassOfATetrahedron) {
  // V = 1/6, centre (1, 1, 1)/4, ∫ x² dV = 1/60: I_xx = 2·6/60 − 2/16, I_xy = −(6/120 − 1/16)
  const TriangleMesh hull = hullOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}});
  EXPECT_NEAR(volume(hull), 1.0 / 6, 1e-16);
  MassProperties expected{1, Vector3d::Constant(0.25), Matrix3d::Constant(1.0 / 80)};
  expected.I_Bcm.diagonal().setConstant(0.2 - 0.125);
  EXPECT_TRUE(sameMass(massProperties(hull, 1), expected, 1e-14));
}

TEST(ConvexHull, OfASphereConverges) {
  double error = 1;
  for (const std::uint32_t n : {16u, 64u, 256u}) {
    const TriangleMesh ball = triangulated(Sphere{1}, n);
    const double off = 1 - volume(hullOf(ball.vertices)) / (4 * M_PI / 3);
    EXPECT_GT(off, 0);
    EXPECT_LT(off, 20.0 / (n * n));
    EXPECT_LT(off, error / 10);
    error = off;
    const MassProperties mass = massProperties(hullOf(ball.vertices), 1);
    EXPECT_NEAR(mass.I_Bcm(0, 0), 0.4, 20.0 / (n * n));
  }
}

TEST(ConvexHull, KeepsTheBitsOfItsCorners) {
  RandomMass random(72);
  std::vector<Vector3d> points;
  for (int k = 0; k < 1000; ++k) points.push_back(random.vector(1));
  std::size_t at = 0;
  const TriangleMesh hull = hullOf(points);
  for (const Vector3d& corner : hull.vertices) {
    while (at < points.size() && points[at] != corner) ++at;
    EXPECT_LT(at, points.size());
  }
  // no point lies outside of any facet
  for (const Triangle& t : hull.triangles) {
    const Vector3d& a = hull.vertices[t[0]];
    const Vector3d n = (hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a).normalized();
    for (const Vector3d& p : points) EXPECT_LT(n.dot(p - a), 1e-12);
  }
}

TEST(ConvexHull, HoldsFarAwayAndOfAnySize) {
  for (const double size : {1e-9, 1e-6, 1.0, 1e6, 1e50}) {
    const TriangleMesh hull = hullOf(cornersOf(Vector3d::Constant(size)));
    EXPECT_NEAR(volume(hull) / std::pow(size, 3), 1, 1e-13);
  }
  std::vector<Vector3d> far = cornersOf(Vector3d::Ones());
  for (Vector3d& p : far) p += Vector3d(1e6, -2e6, 3e6);
  EXPECT_NEAR(volume(hullOf(far)), 1, 1e-9);
  EXPECT_NEAR(volume(boundingBox(hullOf(far))), 1, 1e-8);
}

TEST(ConvexHull, OfWhatHasNoVolumeIsRefused) {
  RandomMass random(73);
  for (int i = 0; i < 50; ++i) {
    const Vector3d a = random.vector(1), u = random.vector(1), v = random.vector(1);
    std::vector<Vector3d> point(5, a), line, plane;
    for (int k = 0; k < 20; ++k) {
      line.push_back(a + random.uniform(-1, 1) * u);
      plane.push_back(a + random.uniform(-1, 1) * u + random.uniform(-1, 1) * v);
    }
    const std::string rule = "convex hull must enclose a volume, but all vertices lie ";
    EXPECT_THAT(refusal(point, 0), HasSubstr(rule + "at one place"));
    EXPECT_THAT(refusal(line, 0), HasSubstr(rule + "on one line"));
    EXPECT_THAT(refusal(plane, 0), HasSubstr(rule + "in one plane"));
    // noise of the file's numbers makes no solid of it
    for (Vector3d& p : plane) p += random.vector(1e-7);
    EXPECT_THAT(refusal(plane, 1e-6), HasSubstr(rule + "in one plane, to within 1e-06 m"));
  }
}

TEST(BoundingBox, OfABoxIsTheBox) {
  RandomMass random(74);
  for (int i = 0; i < 50; ++i) {
    const Vector3d size(random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2));
    const Isometry3d X = random.isometry(3);
    const TriangleMesh box = boundingBox(hullOf(moved(X, cornersOf(size))));
    EXPECT_EQ(checkedMesh(box).fault, "");
    EXPECT_THAT(checkedMesh(box).notices, IsEmpty());
    EXPECT_TRUE(
        sameMass(massProperties(box, 2), transformed(X, massProperties(Box{size}, 2)), 1e-13));
  }
}

TEST(BoundingBox, OfACylinderHasItsDiameterAndLength) {
  RandomMass random(75);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh cylinder =
        transformed(random.isometry(1), triangulated(Cylinder{0.5, 3}, 64));
    EXPECT_NEAR(volume(boundingBox(hullOf(cylinder.vertices))), 3, 0.01);
  }
}

TEST(BoundingBox, HoldsEveryVertexAndIsNoLargerThanThatAlongTheAxes) {
  RandomMass random(76);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vector3d> points;
    Eigen::AlignedBox3d aligned;
    for (int k = 0; k < 30; ++k) {
      points.push_back(random.vector(1));
      aligned.extend(points.back());
    }
    const TriangleMesh hull = hullOf(points), box = boundingBox(hull);
    EXPECT_LE(volume(box), aligned.volume());
    EXPECT_GE(volume(box), volume(hull));
    for (const Triangle& t : box.triangles) {
      const Vector3d& a = box.vertices[t[0]];
      const Vector3d n = (box.vertices[t[1]] - a).cross(box.vertices[t[2]] - a).normalized();
      for (const Vector3d& p : points) EXPECT_LT(n.dot(p - a), 1e-13);
    }
  }
}

}  // namespace rigid_body_sim
