#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/particles.hpp>
#include <rigid_body_sim/mass/shapes.hpp>

#include "support/random_mass.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

MassProperties withMoments(double x, double y, double z) {
  return {1, Vector3d::Zero(), Vector3d(x, y, z).asDiagonal()};
}

std::string faultOf(double x, double y, double z) {
  return massPropertiesFault(withMoments(x, y, z));
}

std::string faultOfEntry(int row, int column, double value) {
  MassProperties body = withMoments(1, 1, 1);
  body.I_Bcm(row, column) = value;
  return massPropertiesFault(body);
}

}  // namespace

TEST(MassPropertiesFault, AcceptsBodiesUpToTheEdge) {
  EXPECT_EQ(faultOf(1, 1, 1), "");
  EXPECT_EQ(faultOf(1, 2, 2.5), "");
  EXPECT_EQ(faultOf(1, 1, 2), "");                // flat plate
  EXPECT_EQ(faultOf(0.1, 0.2, 0.1 + 0.2), "");    // flat plate, rounded
  EXPECT_EQ(faultOf(1, 2, 3 * (1 + 9e-10)), "");  // flat plate, figures of a data sheet
  EXPECT_EQ(faultOf(1e-12, 1, 1), "");            // needle
  EXPECT_EQ(faultOf(1e-12, 1, 1 + 1e-12), "");    // flat needle
  EXPECT_EQ(faultOf(1e-40, 1e-40, 2e-40), "");    // a molecule
  EXPECT_EQ(faultOf(1e60, 1e60, 1e60), "");
}

TEST(MassPropertiesFault, AcceptsPlatesAndNeedlesTurnedAnyWay) {
  RandomMass random(31);
  for (int i = 0; i < 10000; ++i) {
    const Isometry3d X = random.isometry(1);
    const double a = std::pow(10, random.uniform(-12, 0));
    EXPECT_EQ(massPropertiesFault(transformed(X, withMoments(a, 1, 1 + a))), "");
    EXPECT_EQ(massPropertiesFault(transformed(X, withMoments(a, 1, 1))), "");
  }
}

TEST(MassPropertiesFault, AcceptsParticlesInAPlaneAndRefusesThemOnALine) {
  RandomMass random(32);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d corner = random.vector(1), u = random.vector(1), v = random.vector(1);
    Particles plane, line;
    for (int k = 0; k < 5; ++k) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      plane.push_back({1, corner + x * u + y * v, Vector3d::Zero()});
      line.push_back({1, x * u, Vector3d::Zero()});
    }
    EXPECT_EQ(massPropertiesFault(massProperties(plane)), "");
    EXPECT_THAT(massPropertiesFault(massProperties(line)), HasSubstr("positive definite"));
  }
}

TEST(MassPropertiesFault, NamesTheMass) {
  const auto faultOfMass = [](double mass) {
    return massPropertiesFault({mass, Vector3d::Zero(), Matrix3d::Identity()});
  };
  EXPECT_EQ(faultOfMass(-1), "mass must be > 0 kg, got -1");
  EXPECT_EQ(faultOfMass(0), "mass must be > 0 kg, got 0");
  EXPECT_EQ(faultOfMass(kInf), "mass must be a finite number of kg, got inf");
  EXPECT_THAT(faultOfMass(kNan), HasSubstr("mass must be a finite number of kg, got"));
}

// 1/m overflows below 1/1.8e308 = 5.6e-309.
TEST(MassPropertiesFault, NamesMassAndInertiaWithoutAFiniteInverse) {
  const auto faultOfMass = [](double mass) {
    return massPropertiesFault({mass, Vector3d::Zero(), Matrix3d::Identity()});
  };
  EXPECT_EQ(faultOfMass(5.6e-309), "");
  EXPECT_EQ(faultOfMass(5.5e-309),
            "mass must be so large that 1/mass is a finite number, got 5.5e-309 kg");
  EXPECT_THAT(faultOfMass(5e-324), HasSubstr("mass must be so large"));
  EXPECT_EQ(faultOf(5.6e-309, 5.6e-309, 5.6e-309), "");
  EXPECT_EQ(faultOf(5.5e-309, 1e-308, 1e-308),
            "inertia must be so large that its inverse is finite, got principal moments "
            "[5.5e-309, 1e-308, 1e-308] kg m^2");
}

TEST(MassPropertiesFault, NamesTheCentreOfMass) {
  MassProperties body = withMoments(1, 1, 1);
  body.com_B.y() = kInf;
  EXPECT_EQ(massPropertiesFault(body), "center_of_mass must be finite, got [0, inf, 0] m");
}

TEST(MassPropertiesFault, NamesAnInertiaThatIsNotFiniteOrNotSymmetric) {
  EXPECT_THAT(faultOfEntry(0, 0, kNan), HasSubstr("inertia must be finite, got"));
  EXPECT_THAT(faultOfEntry(1, 2, -kInf), HasSubstr("inertia must be finite, got"));
  EXPECT_THAT(faultOfEntry(0, 1, 0.25), HasSubstr("inertia must be symmetric, got"));
  EXPECT_THAT(faultOfEntry(0, 1, 0.25), HasSubstr("0.25"));
  EXPECT_THAT(faultOfEntry(0, 1, 1e-11), HasSubstr("inertia must be symmetric"));
  EXPECT_EQ(faultOfEntry(0, 1, 1e-13), "");
}

TEST(MassPropertiesFault, NamesMomentsThatAreNotPositive) {
  EXPECT_EQ(faultOf(1, 1, -0.5),
            "inertia must be positive definite, got principal moments [-0.5, 1, 1] kg m^2");
  EXPECT_THAT(faultOf(0, 1, 1), HasSubstr("positive definite"));
  EXPECT_THAT(faultOf(0, 0, 0), HasSubstr("positive definite"));
  EXPECT_THAT(faultOf(1e-16, 1, 1), HasSubstr("positive definite"));
  MassProperties coupled = withMoments(1, 1, 1);  // entries all positive, moments −1, 1, 3
  coupled.I_Bcm(0, 1) = coupled.I_Bcm(1, 0) = 2;
  EXPECT_THAT(massPropertiesFault(coupled), HasSubstr("positive definite"));
}

TEST(MassPropertiesFault, NamesMomentsBeyondTheTriangleInequality) {
  EXPECT_EQ(faultOf(5, 1, 1),
            "inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal moments "
            "[1, 1, 5] kg m^2: 2 < 5");
  EXPECT_THAT(faultOf(1, 2, 3 * (1 + 2e-9)), HasSubstr("triangle inequality"));
  EXPECT_THAT(faultOf(1e-12, 1, 1.0001), HasSubstr("triangle inequality"));
  // fine on the diagonal (1 1 1), but not in its own axes (0.2 1 1.8)
  MassProperties coupled = withMoments(1, 1, 1);
  coupled.I_Bcm(0, 1) = coupled.I_Bcm(1, 0) = 0.8;
  EXPECT_THAT(massPropertiesFault(coupled), HasSubstr("triangle inequality"));
}

}  // namespace rigid_body_sim
