#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

#include "support/mass_difference.hpp"
#include "support/random_mass.hpp"

namespace rigid_body_sim {
namespace {

std::vector<MassProperties> randomParts(int count, RandomMass& random) {
  std::vector<MassProperties> parts;
  for (int i = 0; i < count; ++i) parts.push_back(random.part(3));
  return parts;
}

MassProperties sumOfRange(const std::vector<MassProperties>& parts, std::size_t begin,
                          std::size_t end) {
  return combined({parts.begin() + static_cast<std::ptrdiff_t>(begin),
                   parts.begin() + static_cast<std::ptrdiff_t>(end)});
}

Isometry3d at(double x, double y, double z) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(x, y, z);
  return X;
}

}  // namespace

TEST(Parts, AgreeInAnyOrder) {
  RandomMass random(21);
  std::vector<MassProperties> parts = randomParts(1000, random);
  const MassProperties whole = combined(parts);
  for (int i = 0; i < 100; ++i) {
    std::shuffle(parts.begin(), parts.end(), random.generator());
    // each sum is rounded once: 2.2e-16, and the centre of mass enters the next
    EXPECT_TRUE(sameMass(combined(parts), whole, 1e-15));
  }
}

TEST(Parts, AgreeInAnyGrouping) {
  RandomMass random(22);
  for (int i = 0; i < 100; ++i) {
    const std::vector<MassProperties> parts = randomParts(20, random);
    const MassProperties whole = combined(parts);
    const MassProperties one_by_one =
        std::accumulate(parts.begin() + 1, parts.end(), parts.front());
    const MassProperties halves = sumOfRange(parts, 0, 7) + sumOfRange(parts, 7, 20);
    EXPECT_TRUE(sameMass(one_by_one, whole, 1e-13));
    EXPECT_TRUE(sameMass(halves, whole, 1e-13));
  }
}

TEST(Parts, TransformAsTheWhole) {
  RandomMass random(23);
  for (int i = 0; i < 1000; ++i) {
    std::vector<MassProperties> parts = randomParts(5, random);
    const Isometry3d X = random.isometry(3);
    const MassProperties whole = transformed(X, combined(parts));
    for (MassProperties& part : parts) part = transformed(X, part);
    EXPECT_TRUE(sameMass(combined(parts), whole, 1e-13));
  }
}

TEST(Parts, KeepTheirInertiaFarFromTheOrigin) {
  RandomMass random(24);
  for (int i = 0; i < 100; ++i) {
    std::vector<MassProperties> parts = randomParts(10, random);
    const Matrix3d I = combined(parts).I_Bcm;
    for (MassProperties& part : parts) part.com_B += Vector3d(1e6, 1e6, -1e6);
    // the parts' own places are rounded to 1e-10 m
    EXPECT_LE((combined(parts).I_Bcm - I).norm(), 1e-9 * I.norm());
  }
}

TEST(Parts, OfACutBoxSumToTheBox) {
  const Box box{{1.2, 0.6, 2.4}};
  std::vector<MassProperties> pieces;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 5; ++k)
        pieces.push_back(transformed(at((i - 1) * 0.4, (j - 1.5) * 0.15, (k - 2) * 0.48),
                                     massProperties(Box{{0.4, 0.15, 0.48}}, 0.1)));
  EXPECT_TRUE(sameMass(combined(pieces), massProperties(box, 6), 1e-14));
}

TEST(Parts, OfABarbellHaveItsClosedForm) {
  // two spheres 2 d apart: across the bar 2 (2/5 m r² + m d²), along it 2 · 2/5 m r²
  const MassProperties ball = massProperties(Sphere{0.5}, 2);
  const MassProperties barbell = transformed(at(0, 0, 3), ball) + transformed(at(0, 0, -3), ball);
  const Matrix3d I = Vector3d(0.4 + 36, 0.4 + 36, 0.4).asDiagonal();
  EXPECT_TRUE(sameMass(barbell, {4, Vector3d::Zero(), I}, 1e-15));
}

TEST(Parts, CanBeTakenOutAgainAsNegativeMass) {
  RandomMass random(25);
  const MassProperties a = random.part(1), b = random.part(1);
  const MassProperties hole{-b.mass, b.com_B, -b.I_Bcm};
  EXPECT_TRUE(sameMass((a + b) + hole, a, 1e-12));
}

TEST(Parts, WithoutMassLeaveNoNan) {
  EXPECT_EQ(combined({}).mass, 0);
  const MassProperties nothing;
  EXPECT_EQ((nothing + nothing).com_B, Vector3d::Zero());
  EXPECT_EQ((nothing + nothing).I_Bcm, Matrix3d::Zero());
  RandomMass random(26);
  const MassProperties part = random.part(1);
  EXPECT_TRUE(sameMass(part + nothing, part, 1e-15));
  // a flywheel so light that its inertia alone counts
  const MassProperties flywheel{0, {5, 5, 5}, Matrix3d::Identity()};
  EXPECT_EQ((part + flywheel).mass, part.mass);
  EXPECT_LE((part.com_B - (part + flywheel).com_B).norm(), 1e-15);
  EXPECT_LE(((part + flywheel).I_Bcm - part.I_Bcm - Matrix3d::Identity()).norm(), 1e-14);
}

TEST(ParallelAxes, ShiftAndBackIsNothing) {
  RandomMass random(27);
  for (int i = 0; i < 100; ++i) {
    const MassProperties part = random.part(1);
    const Vector3d d = random.vector(1);
    const Matrix3d shifted = parallelAxes(part.I_Bcm, part.mass, d);
    EXPECT_LE((parallelAxes(shifted, -part.mass, d) - part.I_Bcm).norm(),
              1e-15 * 8 * shifted.norm());
    // never less inertia about another point, whatever the axis
    const Vector3d axis = random.vector(1);
    EXPECT_GE(axis.dot(shifted * axis), axis.dot(part.I_Bcm * axis));
  }
}

TEST(Transformed, KeepsTheInertiaSymmetricToTheLastBit) {
  RandomMass random(28);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d I = transformed(random.isometry(1), random.part(1)).I_Bcm;
    EXPECT_EQ(I, Matrix3d(I.transpose()));
  }
}

}  // namespace rigid_body_sim
