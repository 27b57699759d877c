#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/random_mass.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Accepted as it is, nothing turned around.
void expectAccepted(const TriangleMesh& mesh) {
  const CheckedMesh checked = checkedMesh(mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(checked.notices, IsEmpty());
}

}  // namespace

TEST(CheckedMesh, AcceptsTheTriangulationsOfAllShapes) {
  for (const Shape& shape : {Shape(Box{{1, 2, 3}}), Shape(Sphere{1}), Shape(Cylinder{1, 2}),
                             Shape(Capsule{1, 2}), Shape(Ellipsoid{{1, 2, 3}}), Shape(Cone{1, 2})})
    expectAccepted(triangulated(shape, 16));
}

TEST(CheckedMesh, MergesTheVerticesOfASoup) {
  const CheckedMesh checked = checkedMesh(soup(cube()));
  EXPECT_EQ(checked.fault, "");
  EXPECT_EQ(checked.mesh.vertices.size(), 8u);
  EXPECT_EQ(checked.mesh.triangles.size(), 12u);
  EXPECT_TRUE(sameMass(massProperties(checked.mesh, 1), massProperties(cube(), 1), 1e-15));
  const TriangleMesh ball = triangulated(Sphere{1}, 64);
  EXPECT_EQ(checkedMesh(soup(ball)).mesh.vertices.size(), ball.vertices.size());
}

TEST(CheckedMesh, TakesMinusZeroForZero) {
  TriangleMesh mesh = soup(translated({0.5, 0.5, 0.5}, cube()));
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 2)
    for (int k = 0; k < 3; ++k)
      if (mesh.vertices[i](k) == 0) mesh.vertices[i](k) = -0.0;
  EXPECT_EQ(checkedMesh(mesh).fault, "");
  EXPECT_EQ(checkedMesh(mesh).mesh.vertices.size(), 8u);
}

TEST(CheckedMesh, DropsTrianglesThatHaveShrunkToAnEdgeOrAPoint) {
  TriangleMesh mesh = cube();
  mesh.vertices.push_back(mesh.vertices[1]);
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({3, 3, 3});
  const CheckedMesh checked = checkedMesh(mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_EQ(checked.mesh.triangles.size(), 12u);
  EXPECT_EQ(checkedMesh({mesh.vertices, {{0, 0, 1}}}).fault,
            "mesh must have a triangle with three different corners, got 0 of 1");
}

TEST(CheckedMesh, NamesPlacesInTheFewestDigits) {
  TriangleMesh mesh = cube();
  mesh.triangles.erase(mesh.triangles.begin());
  for (Vector3d& v : mesh.vertices) v *= 0.2;
  EXPECT_THAT(checkedMesh(mesh).fault, HasSubstr("from [0.1 -0.1 -0.1] to [-0.1 0.1 -0.1] m"));
}

TEST(CheckedMesh, NamesOpenEdges) {
  TriangleMesh mesh = cube();
  mesh.triangles.erase(mesh.triangles.begin());  // corners 0, 2, 1
  EXPECT_EQ(checkedMesh(mesh).fault,
            "mesh must be closed, got 3 open edges, the first from [0.5 -0.5 -0.5] to "
            "[-0.5 0.5 -0.5] m");
  EXPECT_THAT(checkedMesh({mesh.vertices, {{0, 1, 2}}}).fault,
              StartsWith("mesh must be closed, got 3 open edges"));
}

TEST(CheckedMesh, NamesEdgesThatAreUsedThrice) {
  TriangleMesh mesh = cube();
  mesh.triangles.push_back(mesh.triangles.front());  // doubled: three edges, three triangles each
  EXPECT_EQ(checkedMesh(mesh).fault,
            "mesh edges must have as many triangles on one side as on the other, got 3 that have "
            "not, the first with 3 triangles from [-0.5 -0.5 -0.5] to [-0.5 0.5 -0.5] m");
}

// Its edges would pass, and its mass be twice as great.
TEST(CheckedMesh, NamesATriangleThatIsThereTwice) {
  TriangleMesh mesh = cube();
  for (const Triangle& t : cube().triangles) mesh.triangles.push_back({t[1], t[2], t[0]});
  EXPECT_THAT(checkedMesh(mesh).fault,
              StartsWith("mesh triangles must differ, got one twice, with a corner at [-0.5 -0.5"));
}

TEST(CheckedMesh, NamesNeighboursThatAreOrientedInconsistently) {
  TriangleMesh mesh = cube();
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  EXPECT_THAT(checkedMesh(mesh).fault,
              StartsWith("mesh must be oriented consistently, got 3 edges along which both "
                         "triangles run the same way, the first from ["));
}

TEST(CheckedMesh, NamesAVolumeOfZero) {
  RandomMass random(51);
  // both sides of a triangle; a flat box, turned and far so that rounding makes it other than zero
  EXPECT_EQ(checkedMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}).fault,
            "mesh must enclose a volume, got 0 m^3 within a surface of 1 m^2");
  for (int i = 0; i < 100; ++i) {
    const Vector3d a = random.vector(1), b = random.vector(1), c = random.vector(1);
    const TriangleMesh flat{{a, b, c}, {{0, 1, 2}, {0, 2, 1}}};
    EXPECT_THAT(checkedMesh(flat).fault, HasSubstr("mesh must enclose a volume"));
  }
}

TEST(CheckedMesh, AcceptsAPlateOfAMillionToOneTurnedAnyWay) {
  RandomMass random(52);
  for (int i = 0; i < 100; ++i)
    expectAccepted(transformed(random.isometry(1), triangulated(Box{{1, 1, 1e-6}}, 0)));
}

TEST(CheckedMesh, TurnsAnInwardMeshAroundWithANotice) {
  const CheckedMesh checked = checkedMesh(insideOut(cube()));
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(
      checked.notices,
      ElementsAre("mesh is oriented inwards (volume -1 m^3): its 12 triangles are turned around"));
  EXPECT_DOUBLE_EQ(volume(checked.mesh), 1);
  expectAccepted(checked.mesh);
}

TEST(CheckedMesh, AcceptsACavityUnchanged) {
  const TriangleMesh hollow =
      together(triangulated(Sphere{1}, 32), insideOut(triangulated(Sphere{0.99}, 32)));
  expectAccepted(hollow);
  EXPECT_DOUBLE_EQ(volume(checkedMesh(hollow).mesh), volume(hollow));
}

TEST(CheckedMesh, AcceptsSolidsThatTouchAlongAnEdge) {
  // two cubes with one edge in common: four triangles meet there, two each way
  const TriangleMesh pair = together(cube(), translated({1, 1, 0}, cube()));
  expectAccepted(pair);
  EXPECT_EQ(checkedMesh(pair).mesh.vertices.size(), 14u);
  EXPECT_DOUBLE_EQ(volume(pair), 2);
}

TEST(CheckedMesh, NamesEntriesThatAreNoMesh) {
  EXPECT_EQ(checkedMesh({}).fault, "mesh must have at least one triangle, got 0");
  TriangleMesh mesh = cube();
  mesh.triangles[7][1] = 8;
  EXPECT_EQ(checkedMesh(mesh).fault,
            "mesh triangle 7 refers to vertex 8, but there are 8 vertices");
  mesh = cube();
  mesh.vertices[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(checkedMesh(mesh).fault,
            "mesh vertices must be finite, got [0.5 inf -0.5] for vertex 3");
  mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(checkedMesh(mesh).fault, StartsWith("mesh vertices must be finite"));
  EXPECT_EQ(checkedMesh(scaled(1e120, cube())).fault,
            "mesh must have a volume and a surface that are finite numbers; a smaller scale is "
            "needed");
}

}  // namespace rigid_body_sim
