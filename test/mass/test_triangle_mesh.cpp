#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/shapes.hpp>
#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/random_mass.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

/// A solid without symmetry: a turned capsule and a box, apart from each other.
TriangleMesh lopsided() {
  RandomMass random(41);
  return together(transformed(random.isometry(1), triangulated(Capsule{0.3, 0.8}, 24)),
                  translated({2, -1, 0.5}, triangulated(Box{{0.4, 0.7, 1.1}}, 0)));
}

}  // namespace

TEST(TriangleMesh, OfAUnitCubeIsExact) {
  const TriangleMesh cube = translated({0.5, 0.5, 0.5}, triangulated(Box{{1, 1, 1}}, 0));
  EXPECT_DOUBLE_EQ(volume(cube), 1);
  const MassProperties expected{6, {0.5, 0.5, 0.5}, Matrix3d::Identity()};
  EXPECT_TRUE(sameMass(massProperties(cube, 6), expected, 1e-15));
}

TEST(TriangleMesh, OfATetrahedronHasItsClosedForm) {
  // corners 0, e1, e2, e3: ∫x² = 1/60, ∫xy = 1/120, com 1/4, volume 1/6
  const TriangleMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MassProperties body = ofDensityOne(corner);
  const Matrix3d about_origin = (Matrix3d() << 4, -1, -1, -1, 4, -1, -1, -1, 4).finished() / 120;
  const MassProperties expected{
      1.0 / 6, {0.25, 0.25, 0.25}, parallelAxes(about_origin, -1.0 / 6, {0.25, 0.25, 0.25})};
  EXPECT_TRUE(sameMass(body, expected, 1e-15));
}

TEST(TriangleMesh, TransformsWithItsVertices) {
  RandomMass random(42);
  const MassProperties body = ofDensityOne(lopsided());
  for (int i = 0; i < 300; ++i) {
    const Isometry3d X = random.isometry(3);
    EXPECT_TRUE(sameMass(ofDensityOne(transformed(X, lopsided())), transformed(X, body), 1e-13));
  }
}

TEST(TriangleMesh, KeepsItsInertiaFarFromTheOrigin) {
  const MassProperties body = ofDensityOne(lopsided());
  RandomMass random(43);
  for (int i = 0; i < 30; ++i) {
    const Vector3d away = 1e6 * random.rotation().col(0);
    const MassProperties far = ofDensityOne(translated(away, lopsided()));
    // the vertices themselves are rounded to 6e-11 m
    EXPECT_LE((far.I_Bcm - body.I_Bcm).norm(), 1e-9 * body.I_Bcm.norm());
    // so is the centre of mass; and a side too heavy by 1e-10 moves it by the distance of the parts
    EXPECT_LE((far.com_B - away - body.com_B).norm(), 4e-10);
  }
}

TEST(TriangleMesh, LosesNothingFarFromTheOriginWhereItsVerticesLoseNothing) {
  TriangleMesh mesh = lopsided();
  for (Vector3d& v : mesh.vertices)
    v = (v * 1048576).array().round() / 1048576;  // whole micrometres or so: exact at 2²⁰ m too
  const MassProperties body = ofDensityOne(mesh);
  const Vector3d away(1048576, -1048576, 524288);
  const MassProperties far = ofDensityOne(translated(away, mesh));
  EXPECT_NEAR(far.mass, body.mass, 1e-15 * body.mass);
  // the centre of mass is rounded to half an ulp of 2²⁰ m, once a coordinate …
  EXPECT_LE((far.com_B - away - body.com_B).cwiseAbs().maxCoeff(), 1.17e-10);
  // … and enters the inertia squared
  EXPECT_LE((far.I_Bcm - body.I_Bcm).norm(), 2e-15 * body.I_Bcm.norm());
}

TEST(TriangleMesh, CutInTwoSumsToTheWhole) {
  RandomMass random(44);
  const MassProperties whole = ofDensityOne(lopsided());
  for (int i = 0; i < 100; ++i) {
    const Vector3d n = random.vector(1);
    const double h = random.uniform(-0.5, 0.5) + n.dot(whole.com_B);
    const TriangleMesh upper = above(lopsided(), n, h), lower = above(lopsided(), -n, -h);
    // parts of either size; both must be there for the cut to mean anything
    if (upper.triangles.empty() || lower.triangles.empty()) continue;
    EXPECT_GT(volume(upper), 0);
    EXPECT_LT(volume(upper), whole.mass);
    EXPECT_TRUE(sameMass(ofDensityOne(upper) + ofDensityOne(lower), whole, 1e-13));
  }
}

TEST(TriangleMesh, ScalesAsTheCubeAndTheFifthPower) {
  const MassProperties body = ofDensityOne(lopsided());
  for (const double s : {1e-9, 1e-3, 0.7, 25.4, 1e9}) {
    const MassProperties large = ofDensityOne(scaled(s, lopsided()));
    EXPECT_TRUE(sameMass(
        large, {std::pow(s, 3) * body.mass, s * body.com_B, std::pow(s, 5) * body.I_Bcm}, 1e-13));
  }
}

TEST(TriangleMesh, OfGivenMassIsThatOfTheMatchingDensity) {
  const MassProperties body = ofDensityOne(lopsided());
  const MassProperties heavy = massProperties(lopsided(), 7800 * volume(lopsided()));
  EXPECT_TRUE(sameMass(heavy, {7800 * body.mass, body.com_B, 7800 * body.I_Bcm}, 1e-15));
}

TEST(TriangleMesh, HasTheSamePropertiesInsideOut) {
  EXPECT_EQ(volume(insideOut(lopsided())), -volume(lopsided()));
  EXPECT_TRUE(
      sameMass(massProperties(insideOut(lopsided()), 2), massProperties(lopsided(), 2), 1e-15));
}

TEST(TriangleMesh, WithACavityIsTheSolidLessTheCavity) {
  const TriangleMesh outer = triangulated(Box{{1, 2, 3}}, 0);
  const TriangleMesh inner = translated({0.1, 0.2, 0.3}, triangulated(Sphere{0.3}, 32));
  const MassProperties cavity = ofDensityOne(inner);
  const MassProperties expected =
      ofDensityOne(outer) + MassProperties{-cavity.mass, cavity.com_B, -cavity.I_Bcm};
  EXPECT_TRUE(sameMass(ofDensityOne(together(outer, insideOut(inner))), expected, 1e-14));
}

TEST(TriangleMesh, OfAThinShellKeepsItsDigits) {
  // a hollow box of walls 1e-6 thick: the difference of two volumes keeps ten digits of sixteen
  const Vector3d outer(1, 2, 3), inner = outer - Vector3d::Constant(2e-6);
  const MassProperties full = ofDensityOne(Shape(Box{outer})), hole = ofDensityOne(Box{inner});
  const TriangleMesh shell =
      together(triangulated(Box{outer}, 0), insideOut(triangulated(Box{inner}, 0)));
  EXPECT_TRUE(sameMass(ofDensityOne(shell),
                       full + MassProperties{-hole.mass, hole.com_B, -hole.I_Bcm}, 1e-9));
}

TEST(TriangleMesh, MayBeThinOrHuge) {
  RandomMass random(45);
  for (const Vector3d& size : {Vector3d(1e6, 1e6, 1e-6), Vector3d(1e-6, 1e-6, 1e6),
                               Vector3d(1e-9, 1e-9, 1e-9), Vector3d(1e30, 2e30, 3e30)}) {
    const MassProperties exact = ofDensityOne(Box{size});
    const TriangleMesh mesh = triangulated(Box{size}, 0);
    EXPECT_TRUE(sameMass(ofDensityOne(mesh), exact, 2e-15));
    // turned, its vertices are rounded to an ulp of the greatest size, against the least
    const double rounding = 2.3e-16 * size.maxCoeff() / size.minCoeff();
    const Isometry3d X = random.isometry(0);
    EXPECT_TRUE(
        sameMass(ofDensityOne(transformed(X, mesh)), transformed(X, exact), 1e-14 + 4 * rounding));
  }
}

TEST(TriangleMesh, OfANeedleKeepsItsSmallMoment) {
  const MassProperties needle = massProperties(triangulated(Box{{1, 1e-6, 2e-6}}, 0), 12);
  EXPECT_NEAR(needle.I_Bcm(0, 0), 5e-12, 1e-26);
  EXPECT_EQ(massPropertiesFault(needle), "");
}

TEST(TriangleMesh, ForgetsTheOrderOfItsTriangles) {
  TriangleMesh mesh = lopsided();
  const MassProperties body = ofDensityOne(mesh);
  RandomMass random(46);
  for (int i = 0; i < 30; ++i) {
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random.generator());
    EXPECT_TRUE(sameMass(ofDensityOne(mesh), body, 1e-15));
  }
}

}  // namespace rigid_body_sim
