#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/mass_properties.hpp>

namespace rigid_body_sim {

/// Greatest relative difference of two bodies: of mass, of the centre of mass by its distance from
/// the origin plus the radius of gyration, of the inertia by its greatest entry.
inline double massDifference(const MassProperties& a, const MassProperties& b) {
  const double greatest = b.I_Bcm.cwiseAbs().maxCoeff();
  const double length = b.com_B.norm() + std::sqrt(greatest / std::abs(b.mass));
  return std::max({std::abs(a.mass - b.mass) / std::abs(b.mass),
                   (a.com_B - b.com_B).norm() / length,
                   (a.I_Bcm - b.I_Bcm).cwiseAbs().maxCoeff() / greatest});
}

/// EXPECT_TRUE(sameMass(actual, expected, 1e-13)) prints both where they differ.
inline ::testing::AssertionResult sameMass(const MassProperties& actual,
                                           const MassProperties& expected, double tolerance) {
  const double difference = massDifference(actual, expected);
  if (difference <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "relative difference " << difference << " > " << tolerance << "\nactual:   mass "
         << actual.mass << ", com " << actual.com_B.transpose() << ", inertia\n"
         << actual.I_Bcm << "\nexpected: mass " << expected.mass << ", com "
         << expected.com_B.transpose() << ", inertia\n"
         << expected.I_Bcm;
}

}  // namespace rigid_body_sim
