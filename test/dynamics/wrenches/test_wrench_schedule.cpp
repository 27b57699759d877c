#include <gtest/gtest.h>

#include "dynamics/run/coupling.hpp"
#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PointWrench push(double force, double start, double end) {
  PointWrench wrench;
  wrench.force = {force, 0, 0};
  wrench.start = start;
  wrench.end = end;
  return wrench;
}

double activeForce(const WrenchSchedule& schedule) {
  double sum = 0;
  for (const PointWrench& wrench : schedule.active()) sum += wrench.force.x();
  return sum;
}

TEST(WrenchSchedule, StartsAndEndsAtTheExactInstants) {
  WrenchSchedule schedule;
  schedule.put("", push(1, 0.25, 0.75), 0);
  EXPECT_EQ(schedule.nextEvent(), 0.25);
  EXPECT_FALSE(schedule.advanceTo(0.2));
  EXPECT_TRUE(schedule.advanceTo(0.25));
  EXPECT_EQ(activeForce(schedule), 1);
  EXPECT_EQ(schedule.nextEvent(), 0.75);
  EXPECT_TRUE(schedule.advanceTo(0.75));
  EXPECT_EQ(schedule.size(), 0u);
  EXPECT_EQ(schedule.nextEvent(), kInfinity);
}

TEST(WrenchSchedule, AddsEmptySlotsAndReplacesNamedOnes) {
  WrenchSchedule schedule;
  schedule.put("", push(1, 0, 9), 0);
  schedule.put("", push(2, 0, 9), 0);
  schedule.put("a", push(4, 0, 9), 0);
  schedule.put("a", push(8, 0, 9), 0);
  schedule.advanceTo(0);
  EXPECT_EQ(activeForce(schedule), 1 + 2 + 8);
  schedule.put("a", push(16, 1, 9), 1);
  schedule.advanceTo(1);
  EXPECT_EQ(activeForce(schedule), 1 + 2 + 16);
}

TEST(WrenchSchedule, LetsASuccessorTakeOverAtItsOwnStart) {
  WrenchSchedule schedule;
  schedule.put("a", push(1, 0, kInfinity), 0);
  schedule.put("a", push(2, 5, 6), 0);
  schedule.put("a", push(4, 2, kInfinity), 0);  // drops the one that was to start at 5
  schedule.advanceTo(0);
  EXPECT_EQ(activeForce(schedule), 1);
  schedule.advanceTo(2);
  EXPECT_EQ(activeForce(schedule), 4);
  schedule.advanceTo(5);
  EXPECT_EQ(activeForce(schedule), 4);
}

TEST(WrenchSchedule, StartsALateWrenchNowAtItsFullDuration) {
  WrenchSchedule schedule;
  schedule.put("", push(1, 1, 3), 10);
  schedule.advanceTo(10);
  EXPECT_EQ(activeForce(schedule), 1);
  EXPECT_EQ(schedule.nextEvent(), 12);
}

TEST(WrenchSchedule, DropsAWrenchWithoutDuration) {
  WrenchSchedule schedule;
  schedule.put("", push(1, 2, 2), 0);
  EXPECT_EQ(schedule.size(), 0u);
}

TEST(WrenchSchedule, ClearsOneSlotOrAll) {
  WrenchSchedule schedule;
  schedule.put("a", push(1, 0, 9), 0);
  schedule.put("b", push(2, 0, 9), 0);
  schedule.put("a", push(4, 5, 9), 0);
  schedule.advanceTo(0);
  schedule.clear("a");
  EXPECT_EQ(activeForce(schedule), 2);
  EXPECT_EQ(schedule.size(), 1u);
  EXPECT_EQ(schedule.nextEvent(), 9);
  schedule.clear();
  EXPECT_EQ(schedule.size(), 0u);
}

TEST(WrenchSchedule, TakesManyAtTheSameInstantInOrder) {
  WrenchSchedule schedule;
  for (int i = 0; i < 1000; ++i) schedule.put("", push(1, 1, 2), 0);
  for (int i = 0; i < 1000; ++i) schedule.put("", push(1, 2, 3), 0);
  schedule.advanceTo(1);
  EXPECT_EQ(activeForce(schedule), 1000);
  schedule.advanceTo(2);
  EXPECT_EQ(activeForce(schedule), 1000);
  schedule.advanceTo(3);
  EXPECT_EQ(schedule.size(), 0u);
}

/// A push on a body in the axes of another, from the start.
PointWrench inAxesOf(std::size_t axes, std::size_t body) {
  PointWrench wrench = push(1, 0, 10);
  wrench.body = body;
  wrench.axes = axes;
  return wrench;
}

TEST(CoupledBodies, JoinWhatIsLinkedAndNothingElse) {
  World world;
  world.bodies.resize(6);
  world.bodies[3].fixed = true;
  std::vector<WrenchSchedule> schedules(6);
  for (const auto& [axes, body] : {std::pair<std::size_t, std::size_t>{0, 2}, {2, 1}})
    schedules[body].put("", inAxesOf(axes, body), 0);
  for (WrenchSchedule& schedule : schedules) schedule.advanceTo(0);
  std::vector<std::vector<std::size_t>> groups;
  for (const CoupledBodies& group :
       coupledBodies(world, LawTable(world), {}, schedules, movingBodies(world)))
    groups.push_back(group.members);
  const std::vector<std::vector<std::size_t>> expected{{0, 1, 2}, {4}, {5}};
  EXPECT_EQ(groups, expected);
}

}  // namespace
}  // namespace rigid_body_sim
