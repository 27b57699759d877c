#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "support/mesh_edits.hpp"
#include "support/random_mass.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr double kSingleUlp = std::numeric_limits<float>::epsilon();  // of single precision, at 1 m
const Vector3d kRounding = Vector3d::Constant(4 * kSingleUlp);

/// Cube of a metre that stands obliquely at the origin.
TriangleMesh turnedCube() {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return transformed(X, triangulated(Box{{1, 1, 1}}, 0));
}

/// Each triangle with corners of its own, each coordinate off by one ulp at most.
TriangleMesh rounded(const TriangleMesh& mesh, unsigned seed) {
  RandomMass random(seed);
  TriangleMesh loose = soup(mesh);
  for (Vector3d& v : loose.vertices) v += random.vector(kSingleUlp);
  return loose;
}

void expectSameBits(const TriangleMesh& a, const TriangleMesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i], b.vertices[i]);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace

TEST(Welding, ClosesASolidWhoseCornersDifferByRounding) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const CheckedMesh checked = checkedMesh(rounded(turnedCube(), seed), kRounding);
    EXPECT_EQ(checked.fault, "");
    EXPECT_EQ(checked.mesh.vertices.size(), 8u);
    EXPECT_EQ(checked.mesh.triangles.size(), 12u);
    EXPECT_NEAR(volume(checked.mesh), 1, 10 * kSingleUlp);
  }
  const TriangleMesh ball = triangulated(Sphere{1}, 64);
  const CheckedMesh checked = checkedMesh(rounded(ball, 1), kRounding);
  EXPECT_EQ(checked.fault, "");
  EXPECT_EQ(checked.mesh.vertices.size(), ball.vertices.size());
}

TEST(Welding, SaysWhatItWelded) {
  TriangleMesh mesh = soup(turnedCube());
  mesh.vertices[4].x() += kSingleUlp;
  const CheckedMesh checked = checkedMesh(mesh, kRounding);
  EXPECT_THAT(checked.notices,
              ElementsAre("mesh has 4 open edges, and is closed: of its vertices, 1 are welded to "
                          "others at most "
                          "1.19209e-07 m away, within the rounding of the file's numbers "
                          "(4.76837e-07 m)"));
}

// near along two axes, and not along the third
TEST(Welding, JoinsNoVerticesThatAreApartAlongOneAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    TriangleMesh mesh = soup(turnedCube());
    mesh.vertices[4][axis] += 1.5 * kRounding[axis];
    const CheckedMesh checked = checkedMesh(mesh, kRounding);
    EXPECT_THAT(checked.fault, StartsWith("mesh must be closed")) << axis;
  }
}

TEST(Welding, NeedsToKnowHowTheNumbersWereRounded) {
  EXPECT_THAT(checkedMesh(rounded(turnedCube(), 1)).fault, StartsWith("mesh must be closed"));
}

// A plate thinner than the tolerance, which welding would press flat.
TEST(Welding, KeepsTheBitsOfAClosedMesh) {
  const TriangleMesh plate = triangulated(Box{{1, 1, 1e-7}}, 0);
  const CheckedMesh checked = checkedMesh(plate, kRounding);
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(checked.notices, IsEmpty());
  expectSameBits(checked.mesh, checkedMesh(plate).mesh);
}

TEST(Welding, KeepsAClosedShellBesideAnOpenOne) {
  const TriangleMesh plate = translated({3, 0, 0}, triangulated(Box{{1, 1, 1e-7}}, 0));
  const CheckedMesh checked = checkedMesh(together(rounded(turnedCube(), 2), plate), kRounding);
  EXPECT_EQ(checked.fault, "");
  ASSERT_EQ(checked.mesh.vertices.size(), 16u);
  TriangleMesh rest{{checked.mesh.vertices.begin() + 8, checked.mesh.vertices.end()}, {}};
  for (std::size_t i = 12; i < 24; ++i) {
    const Triangle& t = checked.mesh.triangles[i];
    rest.triangles.push_back({t[0] - 8, t[1] - 8, t[2] - 8});
  }
  expectSameBits(rest, checkedMesh(plate).mesh);
}

TEST(Welding, KeepsTwoCubesAThousandthOfTheirSizeApart) {
  const TriangleMesh box = triangulated(Box{{1, 1, 1}}, 0);
  const TriangleMesh pair = together(box, translated({1.001, 0, 0}, box));
  // numbers however coarse
  for (const double rounding : {4 * kSingleUlp, 1e-4, 1.0}) {
    const CheckedMesh checked = checkedMesh(rounded(pair, 3), Vector3d::Constant(rounding));
    EXPECT_EQ(checked.fault, "");
    EXPECT_EQ(checked.mesh.vertices.size(), 16u);
    EXPECT_NEAR(volume(checked.mesh), 2, 20 * kSingleUlp);
  }
}

TEST(Welding, ClosesNoHole) {
  TriangleMesh open = rounded(turnedCube(), 4);
  open.triangles.pop_back();
  EXPECT_THAT(checkedMesh(open, kRounding).fault,
              StartsWith("mesh must be closed, got 3 open edges"));
}

// A rim of edges shorter than the tolerance around a hole: vertex by vertex, it would shrink to
// nothing.
TEST(Welding, DoesNotCollapseAChainOfNearVertices) {
  TriangleMesh cone = triangulated(Cone{1, 2}, 64);
  for (Vector3d& v : cone.vertices)
    if (v.z() < 0) v.head<2>() *= 5 * kSingleUlp;
  TriangleMesh open = cone;
  open.triangles.clear();
  for (const Triangle& t : cone.triangles) {  // without its base
    const bool base =
        cone.vertices[t[0]].z() < 0 && cone.vertices[t[1]].z() < 0 && cone.vertices[t[2]].z() < 0;
    if (!base) open.triangles.push_back(t);
  }
  EXPECT_THAT(checkedMesh(open, kRounding).fault, HasSubstr("mesh must be closed"));
}

}  // namespace rigid_body_sim
