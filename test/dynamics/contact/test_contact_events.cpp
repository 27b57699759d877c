#include <gtest/gtest.h>

#include "support/contact_benches.hpp"

/// Touches and releases that are reported.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

/// A ball that meets the ground after 0.1 s and leaves it 0.03 s later.
Bench fallingBall() {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  test::addBall(bench, 0.1, 1, motionAt({0, 0, 0.15005}), HalfSpace{}, contactOf(1e4, 1, 0, 0));
  return bench;
}

void expectSameEvents(const std::vector<ContactEvent>& a, const std::vector<ContactEvent>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].t, b[i].t);
    EXPECT_EQ(a[i].touch, b[i].touch);
  }
}

TEST(ContactEvents, AreNoneOfAnEarlierStepWhereAStateIsSet) {
  Simulation sim = fallingBall().simulation("auto", 0.01);
  std::size_t events = 0;
  while (events < 2) {
    sim.step();
    events += sim.contactEvents().size();
  }
  for (int i = 0; i < 5; ++i) sim.step();  // in the air again, long before the next touch
  ASSERT_TRUE(sim.contactEvents().empty());
  sim.setState(0, sim.body(0));
  EXPECT_TRUE(sim.contactEvents().empty());
}

TEST(ContactEvents, StayWhereAStepIsTakenBack) {
  Simulation sim = fallingBall().simulation("auto", 0.01);
  while (sim.contactEvents().empty()) sim.step();
  const std::vector<ContactEvent> events = sim.contactEvents();
  ASSERT_EQ(events.size(), 1u);  // it is in contact, and stays so over the next step
  PointWrench push;
  push.force = {1e308, 0, 0};
  push.end = 1;
  sim.applyWrench("push", push);
  EXPECT_THROW(sim.step(), SimulationDiverged);
  expectSameEvents(sim.contactEvents(), events);
}

}  // namespace
}  // namespace rigid_body_sim
