#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/taylor_segment.hpp>

#include "support/applied_load.hpp"
#include "support/random_bodies.hpp"
#include "support/reference_motion.hpp"

namespace rigid_body_sim {
namespace {

using reference::Real;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Body bodyOf(double mass, const Vector3d& I) {
  Body body;
  body.mass = mass;
  body.I = I;
  body.inv_I = I.cwiseInverse();
  body.X_BP.setIdentity();
  body.q_BP.setIdentity();
  return body;
}

BodyState turningAt(const Body& body, const Vector3d& w_P) {
  BodyState state;
  state.L_P = body.I.cwiseProduct(w_P);
  state.L_W = rotate(state.q_WP, state.L_P);
  return state;
}

HeldWrench held(const std::vector<PointWrench>& applied) {
  HeldWrench wrench;
  for (const PointWrench& a : applied) wrench.add(a);
  return wrench;
}

/// Five kinds of wrench: a couple and a force at a point of the body, both with world axes; the
/// two with the body's; a force at a world point. alpha: the angular acceleration they are made to
/// cause, about [rad/s²].
PointWrench randomWrench(Draw& draw, int kind, const Body& body, double alpha) {
  const double torque = alpha * body.I.maxCoeff();
  const double length = std::sqrt(body.I.maxCoeff() / body.mass);
  PointWrench a;
  if (kind == 0) a.torque = draw.vector(torque);
  if (kind == 1 || kind == 4) a.force = draw.vector(torque / length);
  if (kind == 1 || kind == 4) a.point = draw.vector(length);
  if (kind == 2 || kind == 3) a.axes = 0;
  if (kind == 2) a.torque = body.I.cwiseProduct(draw.vector(alpha));
  if (kind == 3) a.force = draw.vector(torque / length);
  if (kind == 4) a.point_frame = kWorld;
  return a;
}

/// Greatest errors of a state against the reference: attitude [rad]; the rest relative.
struct Errors {
  Real attitude = 0;
  Real w = 0;
  Real L_P = 0;
  Real L_W = 0;
  Real x = 0;
  Real p = 0;

  void add(const Body& body, const BodyState& s, const reference::Motion& m, Real w_size) {
    const reference::Vector I = body.I.cast<Real>();
    const reference::Vector L = I.cwiseProduct(m.w);
    const Real w_scale = std::max(m.w.norm(), w_size);
    const Real L_scale = std::max(L.norm(), w_size * I.minCoeff());
    const reference::Vector position = s.x_W.cast<Real>() + s.x_low_W.cast<Real>();
    attitude = std::max(attitude, reference::attitudeError(s.q_WP, m));
    w = std::max(w, (s.L_P.cast<Real>().cwiseQuotient(I) - m.w).norm() / w_scale);
    L_P = std::max(L_P, (s.L_P.cast<Real>() - L).norm() / L_scale);
    L_W = std::max(L_W, (s.L_W.cast<Real>() - m.R() * L).norm() / L_scale);
    x = std::max(x, (position - m.x).norm() / (1 + m.x.norm()));
    p = std::max(p, (s.p_W.cast<Real>() / Real(body.mass) - m.v).norm() / (1 + m.v.norm()));
  }
};

const Vector3d kGravity(0, 0, -9.81);

}  // namespace

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
TEST(TaylorSegment, IsValidToRoundingForItsLength) {
  Draw draw(7);
  Errors errors;
  for (double alpha : {1e-9, 1e-3, 1.0, 1e3}) {
    for (int i = 0; i < 120; ++i) {
      const Body body = draw.box(i % 4);
      const BodyState start = draw.state(body, 1);
      std::vector<PointWrench> applied;
      for (int j = 0; j < i % 4; ++j)
        applied.push_back(randomWrench(draw, (i / 3 + j) % 5, body, alpha));
      const TaylorSegment segment(body, held(applied), kGravity, start);
      const double h = segment.validFor();
      const reference::Motion exact =
          reference::advance(body, reference::appliedLoad(body, kGravity, applied),
                             reference::toMotion(body, start), 0, h, h / 2);
      errors.add(body, segment.at(h), exact, 1);
    }
  }
  // measured 6.9e-16, 1.9e-15, 1.2e-15, 1.8e-15, 3.9e-16, 4.7e-16; w stands out where torque in
  // world axes acts on a needle, whose spin takes up the rounding of R times the ratio of moments:
  // 1e-14 with other seeds
  EXPECT_LE(double(errors.attitude), 1e-15);
  EXPECT_LE(double(errors.w), 1e-14);
  EXPECT_LE(double(errors.L_P), 2e-15);
  EXPECT_LE(double(errors.L_W), 2e-15);
  EXPECT_LE(double(errors.x), 1e-15);
  EXPECT_LE(double(errors.p), 1e-15);
}

// A needle takes a body torque and its own inertia without loss, at inertia ratios up to 1e12.
TEST(TaylorSegment, KeepsTheAttitudeOfNeedles) {
  Draw draw(11);
  Errors errors;
  for (int i = 0; i < 100; ++i) {
    const Body body = draw.box(6);
    const BodyState start = draw.state(body, 1);
    PointWrench applied;
    applied.axes = 0;
    applied.torque = body.I.cwiseProduct(draw.vector(std::pow(10, draw.uniform(-3, 3))));
    const TaylorSegment segment(body, held({applied}), kGravity, start);
    const double h = segment.validFor();
    const reference::Motion exact =
        reference::advance(body, reference::appliedLoad(body, kGravity, {applied}),
                           reference::toMotion(body, start), 0, h, h / 2);
    errors.add(body, segment.at(h), exact, 1);
  }
  EXPECT_LE(double(errors.attitude), 1e-15);
  EXPECT_LE(double(errors.w), 2e-15);
}

// Must hold 4 of the project: 1000 changes of wrench in 10 s, each at an instant of no step.
TEST(TaylorSegment, FollowsAThousandChangesToRounding) {
  for (const std::size_t axes : {kWorld, std::size_t{0}}) {
    Draw draw(5);
    const Body body = bodyOf(2, Vector3d(1, 2, 2.5));
    const BodyState start = turningAt(body, Vector3d(1, 1.5, 0.5));
    BodyState state = start;
    reference::Motion exact = reference::toMotion(body, start);
    for (int i = 0; i < 1000; ++i) {
      PointWrench applied;
      applied.axes = axes;
      applied.force = draw.vector(3);
      applied.point = draw.vector(0.3);
      applied.torque = draw.vector(1);
      const double h = draw.uniform(0.005, 0.015);
      state = advanceTaylor(body, held({applied}), kGravity, state, h);
      exact = reference::advance(body, reference::appliedLoad(body, kGravity, {applied}), exact, 0,
                                 h, h, 1e-17L);
    }
    EXPECT_LE(reference::attitudeError(state.q_WP, exact), 1e-12);
    EXPECT_LE((state.L_W - rotate(state.q_WP, state.L_P)).norm(), 1e-12 * state.L_W.norm());
  }
}

// Case C of the comparison with other engines. An ulp of L after 2 s grows to 1e-12 rad after 10 s,
// and each of the 191 segments adds its own: measured 1.5e-13 (1.2e-11 with shorter segments of
// degree 16). The reference holds 2e-18 a step, which grows alike, to the 1.1e-13 that the series
// in long double differs by.
TEST(TaylorSegment, DrivesABoxThroughTenSeconds) {
  const Body body = bodyOf(2, 2.0 / 12 * Vector3d(0.3125, 1.0625, 1.25));
  PointWrench applied;
  applied.force = Vector3d(1, 2, 12);
  applied.point = Vector3d(0.3, -0.1, 0.05);
  const HeldWrench wrench = held({applied});
  const reference::Motion exact =
      reference::advance(body, reference::appliedLoad(body, kGravity, {applied}),
                         reference::toMotion(body, BodyState()), 0, 10, 0.1L);
  const BodyState end = advanceTaylor(body, wrench, kGravity, BodyState(), 10.0);
  EXPECT_LE(reference::attitudeError(end.q_WP, exact), 1e-11);
  const BodyStateT<Real> precise =
      advanceTaylor<Real>(body, wrench, kGravity, BodyStateT<Real>(), 10);
  EXPECT_LE((precise.q_WP.coeffs() - exact.q.coeffs()).norm(), 1e-12);
}

// L_W = L_W0 + tau_W dt to the bit, under couples fixed in the world.
TEST(TaylorSegment, AddsTheExactImpulseOfAWorldCouple) {
  Draw draw(17);
  const Body body = draw.box(2);
  const BodyState start = draw.state(body, 1);
  HeldWrench wrench;
  wrench.tau_W = draw.vector(0.1 * start.L_W.norm());
  const TaylorSegment segment(body, wrench, kGravity, start);
  for (int i = 1; i <= 10; ++i) {
    const double h = segment.validFor() * i / 10;
    EXPECT_EQ(segment.at(h).L_W, start.L_W + wrench.tau_W * h);
  }
}

// Impulse = force × duration, and L·f is constant under a force f at a point of the body.
TEST(TaylorSegment, BalancesMomentum) {
  Draw draw(19);
  for (int i = 0; i < 50; ++i) {
    const Body body = draw.box(1);
    const BodyState start = draw.state(body, 1);
    const PointWrench applied = randomWrench(draw, 1, body, 1);
    const BodyState end = advanceTaylor(body, held({applied}), kGravity, start, 3.0);
    const Vector3d impulse = 3 * (applied.force + body.mass * kGravity);
    EXPECT_LE((end.p_W - start.p_W - impulse).norm(), 1e-13 * (impulse.norm() + start.p_W.norm()));
    EXPECT_NEAR(end.L_W.dot(applied.force), start.L_W.dot(applied.force),
                1e-13 * end.L_W.norm() * applied.force.norm());
  }
}

// The power of the wrench, f·v + τ·ω, integrated by Simpson's rule over 400 points of dense output,
// is the gain of kinetic energy. The rule's own error, as (h ω)⁴, is what is left.
TEST(TaylorSegment, GainsTheWorkOfItsWrench) {
  Draw draw(23);
  for (int kind = 0; kind < 5; ++kind) {
    const Body body = draw.box(0.5);
    const BodyState start = draw.state(body, 1);
    const HeldWrench wrench = held({randomWrench(draw, kind, body, 1)});
    const TaylorSegment segment(body, wrench, kGravity, start);
    const double h = segment.validFor();
    const auto power = [&](double t) {
      const BodyState s = segment.at(t);
      const Wrench w = wrench.at(s);
      const Vector3d w_P = angularVelocity(body.inv_I, s.L_P);
      return (w.f_W + body.mass * kGravity).dot(s.p_W) / body.mass + w.tau_P.dot(w_P) +
             w.tau_W.dot(rotate(s.q_WP, w_P));
    };
    double work = 0;
    for (int i = 0; i <= 400; ++i)
      work += (i % 400 == 0 ? 1 : 2 + 2 * (i % 2)) * power(h * i / 400) * h / 1200;
    const double gain = kineticEnergy(body, segment.at(h)) - kineticEnergy(body, start);
    EXPECT_NEAR(gain, work, 1e-12 * (kineticEnergy(body, start) + std::abs(work)));
  }
}

// Length, mass and time in units that are powers of two apart change no bit; 1e±150 in the rates
// and moments must neither overflow nor underflow on the way.
TEST(TaylorSegment, HoldsInEveryUnit) {
  Draw draw(29);
  for (int i = 0; i < 60; ++i) {
    const Body body = draw.box(1);
    const BodyState start = draw.state(body, 1);
    std::vector<PointWrench> applied;
    for (int j = 0; j < 1 + i % 3; ++j)
      applied.push_back(randomWrench(draw, (i / 3 + j) % 5, body, 1));
    const double m = std::ldexp(1, int(draw.uniform(-160, 160)));
    const double l = std::ldexp(1, int(draw.uniform(-80, 80)));
    const double t = std::ldexp(1, int(draw.uniform(-160, 160)));
    const double force = m * l / t / t;

    Body scaled = body;
    scaled.mass *= m;
    scaled.I *= m * l * l;
    scaled.inv_I /= m * l * l;
    BodyState scaled_start = start;
    scaled_start.x_W *= l;
    scaled_start.p_W *= m * l / t;
    scaled_start.L_P *= m * l * l / t;
    scaled_start.L_W *= m * l * l / t;
    std::vector<PointWrench> scaled_applied = applied;
    for (PointWrench& a : scaled_applied) {
      a.force *= force;
      a.torque *= force * l;
      a.point *= l;
    }
    const TaylorSegment segment(body, held(applied), kGravity, start);
    const TaylorSegment other(scaled, held(scaled_applied), kGravity * (l / t / t), scaled_start);
    EXPECT_EQ(other.validFor(), t * segment.validFor());
    const BodyState end = segment.at(segment.validFor());
    const BodyState other_end = other.at(other.validFor());
    EXPECT_EQ(other_end.q_WP.coeffs(), end.q_WP.coeffs());
    EXPECT_EQ(other_end.x_W, l * end.x_W);
    EXPECT_EQ(other_end.p_W, m * l / t * end.p_W);
    EXPECT_EQ(other_end.L_P, m * l * l / t * end.L_P);
    EXPECT_EQ(other_end.L_W, m * l * l / t * end.L_W);
  }
}

// 100 000 steps of 1 µm at a distance of 1e9 m, whose own ulp is 0.1 µm.
TEST(TaylorSegment, KeepsSmallStepsFarOut) {
  const Body body = bodyOf(1, Vector3d(1, 2, 2.5));
  BodyState state;
  state.x_W = Vector3d(1e9, -1e9, 1e9);
  state.p_W = Vector3d(1, 1, 0);
  for (int i = 0; i < 100000; ++i)
    state = TaylorSegment(body, HeldWrench(), Vector3d::Zero(), state).at(1e-6);
  const Vector3d travelled = (state.x_W - Vector3d(1e9, -1e9, 1e9)) + state.x_low_W;
  EXPECT_LE((travelled - Vector3d(0.1, 0.1, 0)).norm(), 1e-13);
}

}  // namespace rigid_body_sim
