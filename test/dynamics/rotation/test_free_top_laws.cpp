#include <cmath>

#include <gtest/gtest.h>

#include "support/free_rotation_errors.hpp"

/// What every free rotation keeps to, whatever its formula.
namespace rigid_body_sim {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Families whose motion does not blow up a rounding error.
const std::vector<BodyFamily> kMild = {BodyFamily::generic,        BodyFamily::needle,
                                       BodyFamily::plate,          BodyFamily::near_symmetric,
                                       BodyFamily::near_sphere,    BodyFamily::near_first_axis,
                                       BodyFamily::near_third_axis};

/// A state on the way taken as a new start; L_W is the constant that it is.
FreeRotation<double> anchoredAt(const SpinningBody& body, const RotationState<double>& state) {
  return FreeTop<double>(body.I).from(state.q_WP, state.L_P, body.L_W());
}

TEST(FreeRotation, GoesOnFromAnyStateOnTheWay) {
  Random random(1);
  double worst = 0;
  for (const auto& [family, name] : bodyFamilies()) {
    for (int i = 0; i < 20; ++i) {
      const SpinningBody body = randomSpinningBody(family, random);
      const double a = uniform(random, -10, 10) / body.spin();
      const double b = uniform(random, -10, 10) / body.spin();
      const FreeRotation<double> motion = freeRotation(body);
      const RotationState<double> between = motion.at(a);
      const Quaterniond q = anchoredAt(body, between).at(b).q_WP;
      const double change = angleBetween(q, motion.at(a + b).q_WP);
      worst = std::max(worst, change / condition({body.I, between.q_WP, between.L_P}, b));
    }
  }
  // a few units of rounding of each component of the state between; measured: 9 eps
  EXPECT_LE(worst, 16 * kEps);
}

TEST(FreeRotation, ComesBackWhenTimeOrMomentumIsReversed) {
  Random random(2);
  double worst_back = 0, worst_reversed = 0;
  for (const BodyFamily family : kMild) {
    for (int i = 0; i < 200; ++i) {
      const SpinningBody body = randomSpinningBody(family, random);
      const double t = uniform(random, 0, 10) / body.spin();
      const FreeRotation<double> motion = freeRotation(body);
      worst_back =
          std::max(worst_back, angleBetween(anchoredAt(body, motion.at(t)).at(-t).q_WP, body.q_WP));
      SpinningBody reversed = body;
      reversed.L_P = -body.L_P;
      worst_reversed = std::max(
          worst_reversed, angleBetween(freeRotation(reversed).at(t).q_WP, motion.at(-t).q_WP));
    }
  }
  EXPECT_LE(worst_back, 2e-14);
  EXPECT_LE(worst_reversed, 4e-15);
}

TEST(FreeRotation, KeepsEnergyAndAngularMomentumForAllTime) {
  Random random(3);
  for (const auto& [family, name] : bodyFamilies()) {
    double worst_T = 0, worst_L = 0;
    for (int i = 0; i < 100; ++i) {
      const SpinningBody body = randomSpinningBody(family, random);
      const double t = randomSign(random) * powerOfTen(random, -3, 9) / body.spin();
      const RotationState<double> state = freeRotation(body).at(t);
      const double T0 = body.L_P.cwiseAbs2().cwiseQuotient(body.I).sum();
      const double T = state.L_P.cwiseAbs2().cwiseQuotient(body.I).sum();
      worst_T = std::max(worst_T, std::abs(T / T0 - 1));
      worst_L = std::max(worst_L,
                         (rotate(state.q_WP, state.L_P) - body.L_W()).norm() / body.L_W().norm());
    }
    // a few roundings of each component
    EXPECT_LE(worst_T, 16 * kEps) << name;
    EXPECT_LE(worst_L, 16 * kEps) << name;
  }
}

constexpr int kAnchors = 10000;

/// How far [rad] a thousand radians in ten thousand anchors end from the same in one.
double driftOverAnchors(const SpinningBody& body) {
  const double h = 0.1 / body.spin();
  RotationState<double> state{body.q_WP, body.L_P};
  for (int i = 0; i < kAnchors; ++i) state = anchoredAt(body, state).at(h);
  return angleBetween(state.q_WP, freeRotation(body).at(kAnchors * h).q_WP);
}

TEST(FreeRotation, DriftsLikeARandomWalkOfRoundingOverManyAnchors) {
  Random random(4);
  for (const BodyFamily family : kMild) {
    const SpinningBody body = randomSpinningBody(family, random);
    // N changes by a unit of rounding, each of effect over the time left: √(N/3) eps condition;
    // an anchor rounds every component of q and L_P a few times. Measured: up to 4.5
    const double walk =
        std::sqrt(kAnchors / 3.0) * kEps * condition(body, 0.1 * kAnchors / body.spin());
    EXPECT_LE(driftOverAnchors(body), 10 * walk) << static_cast<int>(family);
  }
}

TEST(FreeRotation, TakesItsMagnitudeFromTheWorldWhereItIsConstant) {
  Random random(4);
  // the speed of a near-sphere is |L|/I alone; measured: 4e-13, and 1e-10 with |L_P| instead
  EXPECT_LE(driftOverAnchors(randomSpinningBody(BodyFamily::near_sphere, random)), 4e-12);
}

TEST(FreeRotation, IsTheSameToTheLastBitInOtherUnits) {
  // powers of two change no digit: nothing may overflow or underflow on the way
  Random random(5);
  for (const auto& [family, name] : bodyFamilies()) {
    if (name.rfind("near_", 0) == 0 && name.find("axis") != std::string::npos)
      continue;  // their components fill the exponents already
    const SpinningBody body = randomSpinningBody(family, random);
    const double t = 10 / body.spin();
    const RotationState<double> state = freeRotation(body).at(t);
    for (const int inertia : {-99, 0, 99}) {      // 1e-30 … 1e30
      for (const int spin : {-850, -300, 498}) {  // 1e-256 … 1e150
        SpinningBody scaled = body;
        scaled.I *= std::ldexp(1, inertia);
        scaled.L_P = scaled.L_P.unaryExpr([&](double L) { return std::ldexp(L, inertia + spin); });
        const RotationState<double> same = freeRotation(scaled).at(std::ldexp(t, -spin));
        EXPECT_EQ(same.q_WP.coeffs(), state.q_WP.coeffs()) << name << inertia << " " << spin;
      }
    }
  }
}

TEST(FreeRotation, FollowsTheSlowestSpin) {
  for (const double spin : {1e-300, 1e-290}) {
    const SpinningBody body{{1, 2, 3},
                            Quaterniond::Identity(),
                            Vector3d(1, 2, 3).cwiseProduct(Vector3d(0.5, 2, 0.3)) * spin};
    EXPECT_LE(attitudeError(body, 3 / spin), 4e-15) << spin;
  }
}

TEST(FreeRotation, IsExactOnAPrincipalAxis) {
  const Vector3d I(0.3, 0.7, 0.9);
  const Quaterniond q_WP = Quaterniond(0.1, -0.5, 0.3, 0.8).normalized();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double component : {1.7, -1.7}) {
      const Vector3d L_P = component * Vector3d::Unit(axis);
      const Vector3d L_W = rotate(q_WP, L_P);
      for (const double t : {1e-9, 1.0, 1e4, -1e4}) {
        const RotationState<double> state = FreeTop<double>(I).from(q_WP, L_P, L_W).at(t);
        EXPECT_EQ(state.L_P, L_P);
        using L = long double;
        const L angle = std::copysign(L_W.cast<L>().norm(), L_P(axis)) / L(I(axis)) * L(t);
        const Quaternion<L> turn(Eigen::AngleAxis<L>(angle, Vector3<L>::Unit(axis)));
        const Quaternion<L> expected = q_WP.cast<L>() * turn;
        // the rounding of one product of quaternions
        EXPECT_LE(double(angleBetween<L>(state.q_WP.cast<L>(), expected)), 8 * kEps);
      }
    }
  }
}

TEST(FreeRotation, OfABodyAtRestIsNone) {
  for (const Vector3d& I : {Vector3d(1, 1, 1), Vector3d(1, 1, 2), Vector3d(1, 2, 3)}) {
    const Quaterniond q_WP = Quaterniond(0.1, -0.5, 0.3, 0.8).normalized();
    const RotationState<double> state =
        FreeTop<double>(I).from(q_WP, Vector3d::Zero(), Vector3d::Zero()).at(1e300);
    EXPECT_EQ(state.q_WP.coeffs(), q_WP.coeffs());
    EXPECT_EQ(state.L_P, Vector3d::Zero());
  }
}

TEST(FreeTop, TakesTheKindThatTheMomentsPermit) {
  const auto kind = [](double I1, double I2, double I3) {
    return FreeTop<double>(Vector3d(I1, I2, I3)).kind();
  };
  EXPECT_EQ(kind(2, 2, 2), InertiaKind::spherical);
  EXPECT_EQ(kind(1, 2, 2), InertiaKind::symmetric);
  EXPECT_EQ(kind(2, 2, 3), InertiaKind::symmetric);
  EXPECT_EQ(kind(1, 2, 3), InertiaKind::asymmetric);
  EXPECT_EQ(kind(2, 2, std::nextafter(2, 3)), InertiaKind::symmetric);
  EXPECT_EQ(kind(2, std::nextafter(2, 3), 3), InertiaKind::asymmetric);
}

}  // namespace
}  // namespace rigid_body_sim
