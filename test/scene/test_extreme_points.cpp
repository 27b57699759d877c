#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "math/wide.hpp"
#include "scene/meshes/convex_hull.hpp"
#include "scene/meshes/extreme_points.hpp"

namespace rigid_body_sim {
namespace {

using Points = std::vector<Vector3d>;

/// The points of a grid on the surface of a box: corners, and many within edges and faces.
Points tessellatedBox(const Vector3d& size, int cells) {
  Points points;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      for (int k = 0; k <= cells; ++k) {
        const bool on_surface = i % cells == 0 || j % cells == 0 || k % cells == 0;
        if (on_surface)
          points.push_back(size.cwiseProduct(Vector3d(i, j, k) / cells - Vector3d::Constant(0.5)));
      }
  return points;
}

bool isCornerOf(const Vector3d& size, const Vector3d& p, double error) {
  return (p.cwiseAbs() - size / 2).cwiseAbs().maxCoeff() <= error;
}

const Vector3d kSize(0.4, 0.3, 0.2);

}  // namespace

TEST(ExtremePoints, OfATessellatedBoxAreItsEightCorners) {
  for (const int cells : {1, 2, 5}) {
    SCOPED_TRACE(cells);
    const Points corners = extremePoints(convexHull(tessellatedBox(kSize, cells), 0), 0);
    EXPECT_EQ(corners.size(), 8U);
    for (const Vector3d& corner : corners) EXPECT_TRUE(isCornerOf(kSize, corner, 0));
  }
}

TEST(ExtremePoints, IgnoreTheRoundingOfAFile) {
  const double rounding = 1e-7;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-rounding / 4, rounding / 4);
  const Quaterniond turn = Quaterniond(0.9, 0.3, -0.2, 0.1).normalized();
  Points points = tessellatedBox(kSize, 6);
  for (Vector3d& p : points) p = turn * p + Vector3d(noise(random), noise(random), noise(random));
  const TriangleMesh hull = convexHull(points, rounding);
  ASSERT_GT(hull.vertices.size(), 20U);  // which the rounding has made corners of
  const Points corners = extremePoints(hull, rounding);
  EXPECT_EQ(corners.size(), 8U);
  for (const Vector3d& corner : corners)
    EXPECT_TRUE(isCornerOf(kSize, turn.conjugate() * corner, rounding));
}

TEST(ExtremePoints, KeepEveryVertexOfARoundSolid) {
  Points points;
  constexpr int kSides = 100;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * kPi<double> * i / kSides;
    for (const double z : {-0.1, 0.0, 0.1})  // those in the middle lie on straight edges
      points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const Points corners = extremePoints(convexHull(points, 1e-9), 1e-9);
  EXPECT_EQ(corners.size(), 2U * kSides);
  EXPECT_TRUE(
      std::none_of(corners.begin(), corners.end(), [](const Vector3d& p) { return p.z() == 0; }));
}

TEST(ExtremePoints, ThinOutARimThatIsFinerThanTheRounding) {
  const double rounding = 1e-3;
  Points points;
  constexpr int kSides = 2000;  // of a sagitta of 1.2e-6 m
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * kPi<double> * i / kSides;
    for (const double z : {-1.0, 1.0}) points.emplace_back(std::cos(angle), std::sin(angle), z);
  }
  const Points corners = extremePoints(convexHull(points, rounding), rounding);
  EXPECT_LT(corners.size(), 200U);
  ASSERT_GT(corners.size(), 20U);
  // each round of thinning may lose another rounding: 17 are measured, no bound is derived
  for (int i = 0; i < kSides; ++i) {
    double reach = 0;
    for (const Vector3d& p : corners) reach = std::max(reach, p.dot(points[2 * i]));
    EXPECT_GT(reach, 2 - 30 * rounding);
  }
}

}  // namespace rigid_body_sim
