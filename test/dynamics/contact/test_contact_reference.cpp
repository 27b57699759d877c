#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "support/thrown_bodies.hpp"

/// Contact beside an independent reference, which shares nothing with it.
namespace rigid_body_sim {
namespace {

using contact_reference::Pose;
using contact_reference::Real;
using contact_reference::Vec;
using test::Thrown;
using test::ThrownKind;

constexpr double kThrowTime = 0.4;  // [s]

/// The greatest difference of places, attitudes and velocities [m], [rad], [m/s], [rad/s].
Real apart(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  Real worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max({worst, (a[i].x - b[i].x).norm(), (a[i].v - b[i].v).norm(),
                      a[i].q.angularDistance(b[i].q),
                      Vec(a[i].R() * a[i].w - b[i].R() * b[i].w).norm()});
  return worst;
}

/// By how much a deviation of the start has grown at the end, at most, of two deviations.
Real magnificationOf(Thrown& thrown, const std::vector<Pose>& end) {
  constexpr Real kDeviation = 1e-8L;
  const Vec directions[] = {Vec(1, 2, -2) / 3, Vec(-2, 2, 1) / 3};
  Real greatest = 1;
  for (const Vec& direction : directions) {
    std::vector<Pose> start = thrown.start;
    start[0].x += kDeviation / 2 * direction;
    start[0].v += kDeviation / 2 * direction;
    start[0].w += kDeviation * direction;
    const Real grown = apart(thrown.reference.run(start, kThrowTime), end);
    greatest = std::max(greatest, grown / kDeviation);
  }
  return greatest;
}

/// touches: how many there are.
std::vector<Pose> endByAuto(Thrown& thrown, int& touches) {
  thrown.bench.world.solver.horizon = kThrowTime;
  thrown.bench.world.solver.tolerance_stated = true;  // of 1e-9
  Simulation sim = thrown.bench.simulation("auto", 0.01);
  while (sim.time() < kThrowTime - 1e-9) {
    sim.step();
    for (const ContactEvent& event : sim.contactEvents()) touches += event.touch;
  }
  std::vector<Pose> end;
  for (std::size_t i = 0; i < sim.world().bodies.size(); ++i) {
    const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[i], sim.body(i));
    const Eigen::Quaternion<Real> q = m.q_WB.cast<Real>();
    const Vec w = q.toRotationMatrix().transpose() * m.w_W.cast<Real>();
    end.push_back({m.x_W.cast<Real>(), m.v_W.cast<Real>(), q, w});
  }
  return end;
}

/// More of them with RIGID_BODY_SIM_LONG_TESTS.
void expectAgreement(ThrownKind kind, unsigned seed) {
  test::Thrower thrower(seed);
  const int count = std::getenv("RIGID_BODY_SIM_LONG_TESTS") ? 50 : 2;
  for (int i = 0; i < count; ++i) {
    Thrown thrown = thrower.next(kind);
    const std::vector<Pose> truth = thrown.reference.run(thrown.start, kThrowTime);
    const Real magnification = magnificationOf(thrown, truth);
    int touches = 0;
    const Real error = apart(endByAuto(thrown, touches), truth);
    EXPECT_LT(double(error), 1e-9 * double(magnification)) << i;
    EXPECT_GT(touches, 0) << i;
    ::testing::Test::RecordProperty("worst", std::to_string(double(error / magnification)));
  }
}

TEST(ContactReference, AgreesOnThrownBoxes) { expectAgreement(ThrownKind::kBox, 51); }
TEST(ContactReference, AgreesOnThrownCapsules) { expectAgreement(ThrownKind::kCapsule, 52); }
TEST(ContactReference, AgreesOnThrownCoins) { expectAgreement(ThrownKind::kCoin, 53); }
TEST(ContactReference, AgreesOnThrownEllipsoids) { expectAgreement(ThrownKind::kEllipsoid, 54); }
TEST(ContactReference, AgreesOnPairsOfBalls) { expectAgreement(ThrownKind::kBalls, 55); }

// What the steps of the reference leave is far below what it is to tell.
TEST(ContactReference, AgreesWithItselfAtHalfTheStep) {
  test::Thrower thrower(56);
  for (const ThrownKind kind : {ThrownKind::kCoin, ThrownKind::kBalls}) {
    Thrown thrown = thrower.next(kind);
    const std::vector<Pose> end = thrown.reference.run(thrown.start, kThrowTime);
    thrown.reference.flight_step /= 2;
    thrown.reference.contact_step /= 2;
    const std::vector<Pose> finer = thrown.reference.run(thrown.start, kThrowTime);
    EXPECT_LT(double(apart(end, finer)), 1e-10);
  }
}

}  // namespace
}  // namespace rigid_body_sim
