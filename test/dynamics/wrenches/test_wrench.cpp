#include <random>

#include <gtest/gtest.h>

#include "dynamics/wrenches/held_wrench.hpp"
#include "support/worlds.hpp"

namespace rigid_body_sim {
namespace {

Vector3d randomVector(std::mt19937& rng) {
  std::uniform_real_distribution<double> u(-1, 1);
  return {u(rng), u(rng), u(rng)};
}

BodyState randomState(std::mt19937& rng) {
  BodyState s;
  s.x_W = randomVector(rng);
  s.q_WP = rotationExp(Vector3d(3 * randomVector(rng)));
  return s;
}

Vector3d totalTorque(const Wrench& w, const BodyState& s) {
  return w.tau_W + rotate(s.q_WP, w.tau_P);
}

// τ = (r − x) × f; source: Rotenberg, ApplyForce
TEST(ApplyForce, AddsForceAndMomentAboutTheCentreOfMass) {
  BodyState s;
  s.x_W = {1, 1, 1};
  Wrench w;
  applyForce(w, s, {0, 0, 2}, {2, 1, 1});
  applyForce(w, s, {1, 0, 0}, {1, 1, 1});
  EXPECT_EQ(w.f_W, Vector3d(1, 0, 2));
  EXPECT_EQ(w.tau_W, Vector3d(0, -2, 0));
}

TEST(PointWrench, TurnsWithTheFrameThatItIsFixedIn) {
  std::mt19937 rng(1);
  const std::vector<BodyState> bodies{randomState(rng), randomState(rng)};
  for (std::size_t axes : {kWorld, std::size_t{0}, std::size_t{1}}) {
    for (std::size_t point_frame : {kWorld, std::size_t{0}, std::size_t{1}}) {
      PointWrench applied;
      applied.axes = axes;
      applied.point_frame = point_frame;
      applied.force = randomVector(rng);
      applied.torque = randomVector(rng);
      applied.point = randomVector(rng);
      const Matrix3d R =
          axes == kWorld ? Matrix3d(Matrix3d::Identity()) : bodies[axes].q_WP.toRotationMatrix();
      const Vector3d r_W =
          point_frame == kWorld
              ? applied.point
              : Vector3d(bodies[point_frame].x_W +
                         bodies[point_frame].q_WP.toRotationMatrix() * applied.point);
      Wrench expected;
      applyForce(expected, bodies[0], R * applied.force, r_W);
      expected.tau_W += R * applied.torque;
      Wrench w;
      addPointWrench(applied, bodies, w);
      EXPECT_LE((w.f_W - expected.f_W).norm(), 1e-15);
      EXPECT_LE((totalTorque(w, bodies[0]) - expected.tau_W).norm(), 3e-15);
    }
  }
}

// However many wrenches are summed, and whether they are merged or not.
TEST(HeldWrench, EqualsTheSumOfItsParts) {
  std::mt19937 rng(2);
  for (int count : {1, 2, 3, 4, 20}) {
    HeldWrenchSum held_sum;
    std::vector<PointWrench> parts;
    for (int i = 0; i < count; ++i) {
      for (std::size_t axes : {kWorld, std::size_t{0}}) {
        PointWrench applied;
        applied.axes = axes;
        applied.point_frame = axes == kWorld && i % 2 == 1 ? kWorld : 0;
        applied.force = randomVector(rng);
        applied.torque = randomVector(rng);
        applied.point = randomVector(rng);
        ASSERT_TRUE(HeldWrench::holds(applied));
        held_sum.add(applied);
        parts.push_back(applied);
      }
    }
    const HeldWrench held = held_sum.sum();
    EXPECT_LE(held.body_point_forces.size(), 3u);
    EXPECT_LE(held.world_point_forces.size(), 3u);
    for (int i = 0; i < 10; ++i) {
      const std::vector<BodyState> bodies{randomState(rng)};
      Wrench sum;
      for (const PointWrench& applied : parts) addPointWrench(applied, bodies, sum);
      const Wrench at = held.at(bodies[0]);
      // 40 terms of size 1, each of a few ulp
      EXPECT_LE((at.f_W - sum.f_W).norm(), 4e-15 * count);
      EXPECT_LE((totalTorque(at, bodies[0]) - totalTorque(sum, bodies[0])).norm(), 8e-15 * count);
    }
  }
}

TEST(HeldWrench, LeavesAloneWhatDependsOnMoreThanItsBody) {
  PointWrench applied;
  applied.axes = 0;
  applied.point_frame = kWorld;
  EXPECT_FALSE(HeldWrench::holds(applied));
  applied.axes = 1;
  applied.point_frame = 0;
  EXPECT_FALSE(HeldWrench::holds(applied));
}

TEST(HeldWrench, KnowsWhenTheBodyTurnsFreely) {
  HeldWrenchSum held;
  EXPECT_TRUE(held.sum().torqueFree());
  PointWrench at_com;
  at_com.force = {1, 2, 3};
  held.add(at_com);
  EXPECT_TRUE(held.sum().torqueFree());
  at_com.point = {0, 0, 1};
  held.add(at_com);
  EXPECT_FALSE(held.sum().torqueFree());
}

// 1e20 N and 1 N at one point, three others so that all are merged, −1e20 N: 1 N × 5.5 m is left.
TEST(HeldWrench, KeepsWhatForcesThatCancelWereTooGreatToHold) {
  for (std::size_t frame : {kOwnBody, kWorld}) {
    HeldWrenchSum sum;
    const auto add = [&](double force, const Vector3d& point) {
      PointWrench applied;
      applied.force = {0, force, 0};
      applied.point = point;
      applied.point_frame = frame;
      sum.add(applied);
    };
    add(1e20, {5.5, 0, 0});
    add(1, {5.5, 0, 0});
    for (const double z : {1, 2, 3}) add(0.0625, {0, 0, z});
    add(-1e20, {5.5, 0, 0});
    EXPECT_EQ(totalTorque(sum.sum().at(BodyState()), BodyState()).z(), 5.5);
    EXPECT_EQ(sum.sum().f_W.y(), 1 + 3 * 0.0625);
  }
}

// A couple or force of the body itself reaches a needle's small component undiluted.
TEST(HeldWrench, KeepsTheBodysOwnTorqueInItsOwnAxes) {
  HeldWrenchSum sum;
  PointWrench thruster;
  thruster.axes = thruster.point_frame = 0;
  thruster.torque = {0, 1, 0};
  sum.add(thruster);
  const HeldWrench held = sum.sum();
  BodyState s;
  s.q_WP = rotationExp(Vector3d(1, 2, 3));
  EXPECT_EQ(held.at(s).tau_P, Vector3d(0, 1, 0));
  EXPECT_EQ(held.at(s).tau_W, Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace rigid_body_sim
