#include <cmath>
#include <limits>
#include <vector>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>
#include <gtest/gtest.h>

#include "math/elliptic.hpp"
#include "support/body_families.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Complementary parameters from the circle to the edge of the separatrix.
const std::vector<double> kParameters = {1,    0.999999, 0.9,  0.5,   0.1,   1e-2,
                                         1e-4, 1e-6,     1e-8, 1e-10, 1e-12, 1e-15};

double relativeError(double value, double expected) {
  return std::abs(value - expected) / std::abs(expected);
}

TEST(CarlsonIntegral, AgreesWithBoostAndGsl) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = powerOfTen(random, -12, 0), y = powerOfTen(random, -12, 0), z = 1;
    const double p = uniform(random, 1, 2);
    const double rj = carlsonRJ(x, y, z, p);
    worst = std::max({worst, relativeError(rj, boost::math::ellint_rj(x, y, z, p)),
                      relativeError(rj, gsl_sf_ellint_RJ(x, y, z, p, GSL_PREC_DOUBLE))});
  }
  // rounding of a dozen operations on either side; measured: 1.1e-15
  EXPECT_LE(worst, 16 * kEps);
}

TEST(CarlsonIntegral, HoldsTheDigitsOfLongDouble) {
  // special values: RJ(x, x, x, x) = x^-3/2 (DLMF 19.20.6), and Carlson's published RJ(2, 3, 4, 5)
  using L = long double;
  const L eps = std::numeric_limits<L>::epsilon();
  EXPECT_NEAR(double((carlsonRJ<L>(3, 3, 3, 3) * 3 * std::sqrt(L(3)) - 1) / eps), 0, 4);
  EXPECT_NEAR(carlsonRJ(2.0, 3.0, 4.0, 5.0), 0.14297579667156753833, 4 * kEps);
}

TEST(CompleteIntegrals, AgreeWithBoostAndCarlson) {
  for (const double mc : kParameters) {
    const double K = completeIntegrals(mc, 0.0).K;
    // boost takes k and so knows only 1 − k² rounded: compare it where that leaves digits
    if (mc > 1e-3) {
      const double k = std::sqrt(1 - mc);
      EXPECT_LE(relativeError(K, boost::math::ellint_1(k)), 2 * kEps / mc);
    }
    EXPECT_LE(relativeError(K, boost::math::ellint_rf(0.0, mc, 1.0)), 4 * kEps) << "mc " << mc;
    for (const double nu : {0.0, -1e-12, -0.01, -0.3, -1.0}) {
      const double expected = nu / 3 * carlsonRJ(0.0, mc, 1.0, 1 - nu);
      EXPECT_LE(std::abs(completeIntegrals(mc, nu).Pi_minus_K - expected),
                16 * kEps * std::abs(expected))
          << "mc " << mc << " nu " << nu;
    }
  }
}

TEST(IncompletePi, AgreesWithBoostAndWithGslOfOppositeSign) {
  Random random(2);
  double worst_boost = 0, worst_gsl = 0;
  for (int i = 0; i < 2000; ++i) {
    const double phi = uniform(random, -1.57, 1.57);
    const double k2 = uniform(random, 0, 0.999);
    const double nu = -uniform(random, 0, 1);
    const double k = std::sqrt(k2);
    const JacobiValues<double> u = {std::sin(phi), std::cos(phi),
                                    std::sqrt(1 - k2 * std::sin(phi) * std::sin(phi))};
    const double difference = incompletePiMinusF(u, k2, nu);
    const double F = boost::math::ellint_1(k, phi);
    worst_boost =
        std::max(worst_boost, std::abs(difference + F - boost::math::ellint_3(k, nu, phi)));
    // GSL's integrand has the factor 1/(1 + n sin²φ)
    worst_gsl = std::max(worst_gsl,
                         std::abs(difference + F - gsl_sf_ellint_P(phi, k, -nu, GSL_PREC_DOUBLE)));
  }
  // values up to 5; measured: 3e-15 and 1.0e-14, GSL's own error
  EXPECT_LE(worst_boost, 4e-15);
  EXPECT_LE(worst_gsl, 2e-14);
}

TEST(JacobiFunctions, AgreeWithBoostAndGslWhereTheseHaveTheDigits) {
  Random random(3);
  for (const double mc : kParameters) {
    if (mc < 1e-3) continue;  // they take k or m, in which mc has lost its digits
    const JacobiFunctions<double> jacobi(mc);
    const double K = completeIntegrals(mc, 0.0).K;
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const double u = uniform(random, -K, K);
      const JacobiValues<double> ours = jacobi.at(u);
      double cn, dn, gsl_sn, gsl_cn, gsl_dn;
      const double sn = boost::math::jacobi_elliptic(std::sqrt(1 - mc), u, &cn, &dn);
      gsl_sf_elljac_e(u, 1 - mc, &gsl_sn, &gsl_cn, &gsl_dn);
      worst = std::max({worst, std::abs(ours.sn - sn), std::abs(ours.cn - cn),
                        std::abs(ours.dn - dn), std::abs(ours.sn - gsl_sn),
                        std::abs(ours.cn - gsl_cn), std::abs(ours.dn - gsl_dn)});
    }
    EXPECT_LE(worst, 4 * kEps / std::sqrt(mc)) << "mc " << mc;
  }
}

TEST(JacobiFunctions, FulfilTheirIdentitiesForEveryParameter) {
  Random random(4);
  for (const double mc : kParameters) {
    const JacobiFunctions<double> jacobi(mc);
    const double K = completeIntegrals(mc, 0.0).K;
    for (int i = 0; i < 200; ++i) {
      const double u = uniform(random, -K, K);
      const JacobiValues<double> j = jacobi.at(u);
      EXPECT_NEAR(j.sn * j.sn + j.cn * j.cn, 1, 4 * kEps);
      EXPECT_NEAR(j.dn * j.dn, j.cn * j.cn + mc * j.sn * j.sn, 8 * kEps * j.dn);
      // the inverse function: u = sn RF(cn², dn², 1), Carlson's integral of the first kind
      EXPECT_NEAR(j.sn * boost::math::ellint_rf(j.cn * j.cn, j.dn * j.dn, 1.0), u, 1e-12)
          << "mc " << mc;
    }
  }
}

TEST(JacobiFunctions, MatchLongDoubleDownToTheSeparatrix) {
  Random random(5);
  for (const double mc : kParameters) {
    const JacobiFunctions<double> jacobi(mc);
    const JacobiFunctions<long double> wide(mc);
    const double K = completeIntegrals(mc, 0.0).K;
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const double u = uniform(random, -K, K);
      const JacobiValues<double> j = jacobi.at(u);
      const JacobiValues<long double> w = wide.at(u);
      worst = std::max({worst, double(std::abs(j.sn - w.sn)), double(std::abs(j.cn - w.cn)),
                        double(std::abs(j.dn - w.dn))});
    }
    // measured: 3e-16
    EXPECT_LE(worst, 4 * kEps) << "mc " << mc;
  }
}

TEST(JacobiFunctions, AreThoseOfTheCircleAndOfTheSeparatrixAtTheEnds) {
  for (const double u : {-1.5, -1e-3, -1e-12, 0.0, 1e-200, 0.7, 1.5}) {
    const JacobiValues<double> circle = JacobiFunctions<double>(1).at(u);
    EXPECT_NEAR(circle.sn, std::sin(u), kEps);
    EXPECT_NEAR(circle.cn, std::cos(u), kEps);
    EXPECT_EQ(circle.dn, 1);
    // the corrections are of order mc (DLMF 22.10.7)
    const JacobiValues<double> separatrix = JacobiFunctions<double>(1e-30L).at(u);
    EXPECT_NEAR(separatrix.sn, std::tanh(u), 2 * kEps);
    EXPECT_NEAR(separatrix.cn, 1 / std::cosh(u), 2 * kEps);
    EXPECT_NEAR(separatrix.dn, 1 / std::cosh(u), 2 * kEps);
  }
}

}  // namespace
}  // namespace rigid_body_sim
