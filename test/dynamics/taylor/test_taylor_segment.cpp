#include <complex>

#include <gtest/gtest.h>

#include "support/taylor_cases.hpp"

namespace rigid_body_sim {

TEST(TaylorSegment, FliesAParabola) {
  const Body body = bodyOf(2, Vector3d(1, 2, 3));
  BodyState start;
  start.x_W = Vector3d(1, 2, 3);
  start.p_W = Vector3d(4, -6, 8);
  HeldWrench wrench;
  wrench.f_W = Vector3d(2, 0, 4);
  const TaylorSegment segment(body, wrench, kGravity, start);
  EXPECT_EQ(segment.validFor(), std::numeric_limits<double>::infinity());
  const BodyState end = segment.at(3);
  EXPECT_LE((end.x_W - Vector3d(1 + 6 + 4.5, 2 - 9, 3 + 12 + 4.5 * (2 - 9.81))).norm(), 2e-14);
  EXPECT_EQ(end.p_W, start.p_W + 3 * (wrench.f_W + 2 * kGravity));
}

TEST(TaylorSegment, KeepsABodyAtRestAtRest) {
  const TaylorSegment segment(bodyOf(2, Vector3d(1, 2, 3)), HeldWrench(), Vector3d::Zero(),
                              BodyState());
  EXPECT_EQ(segment.validFor(), std::numeric_limits<double>::infinity());
  const BodyState end = segment.at(1e6);
  EXPECT_EQ(end.x_W, Vector3d::Zero());
  EXPECT_EQ(end.L_P, Vector3d::Zero());
  EXPECT_EQ(end.q_WP.coeffs(), Quaterniond::Identity().coeffs());
}

TEST(TaylorSegment, StartsAtItsStart) {
  Draw draw(1);
  const Body body = draw.box(1);
  const BodyState start = draw.state(body, 2);
  const HeldWrench wrench = held({randomWrench(draw, 1, body, 1), randomWrench(draw, 3, body, 1)});
  const BodyState end = TaylorSegment(body, wrench, kGravity, start).at(0);
  EXPECT_EQ(end.x_W, start.x_W);
  EXPECT_EQ(end.p_W, start.p_W);
  EXPECT_EQ(end.L_P, start.L_P);
  EXPECT_EQ(end.L_W, start.L_W);
  EXPECT_LE(angleBetween(end.q_WP, start.q_WP), 2 * kEpsilon);
}

// A force at a point of the world that the body leaves at v: a torque F v t, so that θ = F v t³/6I,
// of whose sine and cosine two terms of three are zero. Up to 67 rad, as below.
TEST(TaylorSegment, TurnsWithTheCubeOfTime) {
  const Body body = bodyOf(2, Vector3d(1, 2, 2.5));
  BodyState start;
  start.p_W = Vector3d(0, 2, 0);
  PointWrench pull;
  pull.force = Vector3d(1, 0, 0);
  pull.point_frame = kWorld;
  const double angle = 1000 / (6 * 2.5);
  const BodyState end = advanceTaylor(body, held({pull}), Vector3d::Zero(), start, 10.0);
  EXPECT_LE(angleBetween(end.q_WP, rotationExp<double>(angle * Vector3d::UnitZ())), 1e-13);
  EXPECT_NEAR(end.L_P.z(), 50, 1e-13);
}

// θ = ω₀ t + τ t²/2I, up to 70 rad, so that 1e-13 is 7 ε θ; measured 5.8e-14.
TEST(TaylorSegment, SpinsUpAboutAPrincipalAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const Body body = bodyOf(2, Vector3d(1, 2, 2.5));
    const BodyState start = turningAt(body, 0.7 * Vector3d::Unit(axis));
    HeldWrench own, world;
    own.tau_P = 1.25 * Vector3d::Unit(axis);
    world.tau_W = own.tau_P;
    const double angle = 0.7 * 10 + 0.5 * 1.25 / body.I[axis] * 100;
    const Quaterniond exact = rotationExp<double>(angle * Vector3d::Unit(axis));
    for (const HeldWrench& wrench : {own, world}) {
      const BodyState end = advanceTaylor(body, wrench, kGravity, start, 10.0);
      EXPECT_LE(angleBetween(end.q_WP, exact), 1e-13);
      EXPECT_NEAR(end.L_P[axis], start.L_P[axis] + 12.5, 3e-14);
      EXPECT_NEAR(end.L_W[axis], start.L_W[axis] + 12.5, 3e-14);
    }
  }
}

// Axisymmetric body under a constant torque of its own; with ω₃ = ω₃₀ + a t, W = ω₁ + i ω₂:
//   W = e^{iΛφ(t)} (W₀ + (M₁ + i M₂)/I_t ∫ e^{−iΛφ} dt),  Λ = (I₃ − I_t)/I_t,  φ = ω₃₀ t + a t²/2.
// The integral is a pair of Fresnel integrals, summed here as a power series in long double:
//   ∫₀ᵘ e^{i c v²} dv = Σ (i c)ⁿ u^{2n+1} / (n! (2n + 1)).
// Source: Longuski, J. Guidance, Control and Dynamics, 1991.
TEST(TaylorSegment, SpinsUpAnAxisymmetricBodyAsFresnel) {
  using Complex = std::complex<Real>;
  const Real It = 2, I3 = 1.5L, w30 = 0.5L, M1 = 0.3L, M2 = -0.2L, M3 = 0.4L, t = 4;
  const Complex W0(0.2L, 0.1L), i(0, 1);
  const Real a = M3 / I3, ratio = (I3 - It) / It, shift = w30 / a;
  const auto gauss = [&](Real u) {
    const Complex ic = -i * ratio * a / Real(2);
    Complex sum = 0, power = u;
    for (int n = 0; n < 80; ++n) {
      sum += power / Real(2 * n + 1);
      power *= ic * u * u / Real(n + 1);
    }
    return sum;
  };
  const auto phase = [&](Real u) { return std::exp(i * ratio * a * u * u / Real(2)); };
  const Complex integral = gauss(t + shift) - gauss(shift);
  const Complex W = phase(t + shift) * (W0 / phase(shift) + Complex(M1, M2) / It * integral);

  const Body body = bodyOf(1, Vector3d(double(It), double(It), double(I3)));
  HeldWrench wrench;
  wrench.tau_P = Vector3d(double(M1), double(M2), double(M3));
  const BodyState start =
      turningAt(body, Vector3d(double(W0.real()), double(W0.imag()), double(w30)));
  const BodyState end = advanceTaylor(body, wrench, kGravity, start, double(t));
  EXPECT_NEAR(end.L_P[0], double(It * W.real()), 4e-15);
  EXPECT_NEAR(end.L_P[1], double(It * W.imag()), 4e-15);
  EXPECT_NEAR(end.L_P[2], double(I3 * (w30 + a * t)), 4e-15);
}

// A body that spins about z under a thrust along its own x:
//   x = F/(m ω²) (1 − cos ωt, ωt − sin ωt),  p = F/ω (sin ωt, 1 − cos ωt).
TEST(TaylorSegment, FollowsASpinningThruster) {
  const double w = 1.7, F = 3, m = 2, t = 10;
  const Body body = bodyOf(m, Vector3d(1, 2, 2.5));
  HeldWrench wrench;
  wrench.f_P = Vector3d(F, 0, 0);
  const BodyState end =
      advanceTaylor(body, wrench, Vector3d(0, 0, 0), turningAt(body, Vector3d(0, 0, w)), t);
  const double c = std::cos(w * t), s = std::sin(w * t), size = F / (m * w * w);
  EXPECT_LE((end.x_W - size * Vector3d(1 - c, w * t - s, 0)).norm(), 1e-13);
  EXPECT_LE((end.p_W - F / w * Vector3d(s, 1 - c, 0)).norm(), 1e-13);
}

TEST(TaylorSegment, TumblesFreelyLikeTheReference) {
  const Body body = bodyOf(1, Vector3d(1, 2, 3));
  const BodyState start = turningAt(body, Vector3d(0.5, 2, 0.3));
  const auto load = reference::appliedLoad(body, Vector3d::Zero(), {});
  const reference::Motion exact =
      reference::advance(body, load, reference::toMotion(body, start), 0, 10, 0.5L);
  const BodyState end = advanceTaylor(body, HeldWrench(), Vector3d(0, 0, 0), start, 10.0);
  EXPECT_LE(reference::attitudeError(end.q_WP, exact), 1e-13);
  EXPECT_EQ(end.L_W, start.L_W);
}

// The claim of validFor: one segment over all of it errs by the rounding of its result, for weak
// and strong wrenches of every kind, alone and together, on bodies from cubes to plates and needles
// of inertia ratio 1e6.

}  // namespace rigid_body_sim
