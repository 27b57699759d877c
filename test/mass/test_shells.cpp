#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "mass/shell_nesting.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/random_mass.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// The volume of a mesh that is accepted, and what is said of it.
struct Outcome {
  double volume;
  std::vector<std::string> notices;
};
Outcome outcome(const TriangleMesh& mesh) {
  const CheckedMesh checked = checkedMesh(mesh);
  EXPECT_EQ(checked.fault, "");
  return {volume(checked.mesh), checked.notices};
}

}  // namespace

TEST(Shells, AreTurnedOutwardsOneByOne) {
  const TriangleMesh small = translated({3, 0, 0}, cube(0.4));
  for (const TriangleMesh& pair :
       {together(cube(), insideOut(small)), together(insideOut(small), cube())}) {
    const CheckedMesh checked = checkedMesh(pair);
    EXPECT_EQ(checked.fault, "");
    EXPECT_THAT(checked.notices,
                ElementsAre("mesh has 1 of 2 shells oriented inwards, the first from [2.8 -0.2 "
                            "-0.2] to [3.2 0.2 0.2] m: their 12 triangles are turned around"));
    EXPECT_TRUE(sameMass(massProperties(checked.mesh, 1),
                         massProperties(together(cube(), small), 1), 1e-14));
  }
  // of the same size, they used to cancel
  const Outcome equal = outcome(together(cube(), insideOut(translated({2, 0, 0}, cube()))));
  EXPECT_DOUBLE_EQ(equal.volume, 2);
  EXPECT_THAT(equal.notices, SizeIs(1));
}

TEST(Shells, OfWhichOneIsACavityStayAsTheyAre) {
  const TriangleMesh hollow = together(cube(), insideOut(cube(0.5)));
  EXPECT_DOUBLE_EQ(outcome(hollow).volume, 0.875);
  EXPECT_THAT(outcome(hollow).notices, IsEmpty());
  // and a solid within the cavity
  const TriangleMesh island = together(hollow, cube(0.2));
  EXPECT_DOUBLE_EQ(outcome(island).volume, 0.883);
  EXPECT_THAT(outcome(island).notices, IsEmpty());
}

TEST(Shells, AreTurnedWithTheShellAroundThem) {
  const TriangleMesh hollow = together(insideOut(cube()), cube(0.5));
  EXPECT_DOUBLE_EQ(outcome(hollow).volume, 0.875);
  EXPECT_THAT(outcome(hollow).notices,
              ElementsAre("mesh is oriented inwards (volume -0.875 m^3): its 24 triangles are "
                          "turned around"));
  const TriangleMesh beside = together(hollow, translated({2, 0, 0}, cube()));
  EXPECT_DOUBLE_EQ(outcome(beside).volume, 1.875);
  EXPECT_THAT(outcome(beside).notices,
              ElementsAre(StartsWith("mesh has 2 of 3 shells oriented inwards")));
}

TEST(Shells, WithinOneAnotherOfTheSameSenseAreNamed) {
  const Outcome nested = outcome(together(cube(), cube(0.5)));
  EXPECT_DOUBLE_EQ(nested.volume, 1.125);
  EXPECT_THAT(nested.notices,
              ElementsAre("shells within another that is oriented the same way: 1, the "
                          "first from [-0.25 -0.25 -0.25] to [0.25 0.25 0.25] m: their volume "
                          "counts twice; to make them cavities, turn them inside out"));
  const TriangleMesh two = together(together(cube(), insideOut(cube(0.5))), insideOut(cube(0.2)));
  EXPECT_THAT(outcome(two).notices, ElementsAre(StartsWith("shells within another")));
}

TEST(Shells, ThatOverlapAreNamed) {
  RandomMass random(61);
  const Matrix3d R = random.rotation();
  Isometry3d X = Isometry3d::Identity();
  X.linear() = R;
  const TriangleMesh bar = triangulated(Box{{3, 0.1, 0.1}}, 0);
  const TriangleMesh crossbar = translated({0.4, 0, 0}, triangulated(Box{{0.1, 3, 0.1}}, 0));
  // with faces in common planes; corner in corner; bars that cross, no corner in the other; round
  for (const TriangleMesh& pair :
       {together(cube(), translated({0.5, 0, 0}, cube())),
        together(cube(), translated({0.9, 0.8, 0.7}, cube())), together(bar, crossbar),
        together(triangulated(Sphere{1}, 16),
                 translated({0.1, 0, 0}, triangulated(Sphere{1}, 24)))}) {
    EXPECT_THAT(outcome(pair).notices,
                ElementsAre(StartsWith("pairs of shells that overlap: 1, the first from")));
    EXPECT_THAT(outcome(transformed(X, pair)).notices, ElementsAre(HasSubstr("overlap")));
  }
}

TEST(Shells, ThatTouchAreNotNamed) {
  RandomMass random(62);
  for (const TriangleMesh& pair :
       {together(cube(), translated({1, 0, 0}, cube(1))),         // a face in common
        together(cube(), translated({0.75, 0.1, 0}, cube(0.5))),  // a smaller one on a face
        together(cube(), translated({1, 1, 0}, cube())),          // an edge
        together(cube(), translated({1, 1, 1}, cube())),          // a corner
        together(cube(), translated({1.001, 0, 0}, cube())),      // apart
        together(cube(), insideOut(translated({0.25, 0, 0}, cube(0.5))))}) {  // a notch's surface
    EXPECT_THAT(outcome(pair).notices, IsEmpty());
    Isometry3d X = random.isometry(3);
    EXPECT_THAT(outcome(transformed(X, pair)).notices, IsEmpty());
  }
}

TEST(Shells, ThatTouchAreStillTurnedOneByOne) {
  for (const Vector3d& beside : {Vector3d(1, 1, 0), Vector3d(1, 1, 1)}) {  // an edge, a corner
    const Outcome pair = outcome(together(cube(), insideOut(translated(beside, cube()))));
    EXPECT_DOUBLE_EQ(pair.volume, 2);
    EXPECT_THAT(pair.notices, ElementsAre(StartsWith("mesh has 1 of 2 shells oriented inwards")));
  }
}

TEST(Shells, AreTooManyToCompareOnlyWhenVeryMany) {
  TriangleMesh many;
  for (int i = 0; i < 1000; ++i)
    many = together(std::move(many),
                    translated({2.0 * (i % 10), 2.0 * (i / 10 % 10), i / 100 * 2.0}, cube()));
  EXPECT_DOUBLE_EQ(outcome(many).volume, 1000);
  EXPECT_THAT(outcome(many).notices, IsEmpty());
  TriangleMesh nested;
  for (int i = 0; i < 1000; ++i) nested = together(std::move(nested), cube(1 - 1e-4 * i));
  EXPECT_THAT(outcome(nested).notices,
              ElementsAre(StartsWith("mesh has 1000 shells, too many to compare")));
}

TEST(Shells, WindAboutWhatLiesWithinThem) {
  const TriangleMesh mesh = together(cube(), translated({5, 0, 0}, insideOut(cube())));
  const std::vector<Shell> shells = shellsOf(mesh, EdgeUses(mesh));
  ASSERT_THAT(shells, SizeIs(2));
  EXPECT_NEAR(windingNumber(mesh, shells[0], {0.3, -0.2, 0.4}), 1, 1e-14);
  EXPECT_NEAR(windingNumber(mesh, shells[0], {0.3, -0.2, 0.6}), 0, 1e-14);
  EXPECT_NEAR(windingNumber(mesh, shells[0], {0.3, -0.2, 0.5}), 0.5, 1e-14);
  EXPECT_NEAR(windingNumber(mesh, shells[1], {5, 0, 0}), -1, 1e-14);
}

}  // namespace rigid_body_sim
