#include <gtest/gtest.h>

#include "ros/clock/pacer.hpp"

namespace rigid_body_sim {
namespace {

Pacer::Clock::time_point at(double seconds) {
  return Pacer::Clock::time_point() +
         std::chrono::duration_cast<Pacer::Clock::duration>(std::chrono::duration<double>(seconds));
}

// readings of the clock are whole nanoseconds
constexpr double kNanosecond = 1.01e-9;

}  // namespace

TEST(Pacer, WaitsAsLongAsTheFactorSays) {
  Pacer pacer(2);
  pacer.restart(10, at(100));
  EXPECT_NEAR(pacer.wait(11, at(100)), 0.5, kNanosecond);
  EXPECT_NEAR(pacer.wait(11, at(100.2)), 0.3, kNanosecond);
}

TEST(Pacer, NeverWaitsWithFactorZero) {
  Pacer pacer(0);
  pacer.restart(0, at(100));
  EXPECT_LE(pacer.wait(1e9, at(100)), 0);
}

TEST(Pacer, CatchesUpASmallBacklog) {
  Pacer pacer(1);
  pacer.restart(0, at(100));
  pacer.begin(0.01, 0.01, at(100.1));
  EXPECT_EQ(pacer.overruns(), 1);
  EXPECT_NEAR(pacer.wait(0.1, at(100.1)), 0, kNanosecond);
}

TEST(Pacer, DropsABacklogBeyondTheLimit) {
  Pacer pacer(1);
  pacer.restart(0, at(100));
  pacer.begin(0.01, 0.01, at(101));
  EXPECT_EQ(pacer.overruns(), 1);
  EXPECT_NEAR(pacer.wait(0.02, at(101)), 0.01, kNanosecond);
}

TEST(Pacer, CountsNoOverrunForAStepInTime) {
  Pacer pacer(1);
  pacer.restart(0, at(100));
  pacer.begin(0.01, 0.01, at(100.015));
  EXPECT_EQ(pacer.overruns(), 0);
}

TEST(Pacer, GoesOnFromWhereTimeIsAtAnotherFactor) {
  Pacer pacer(2);
  pacer.restart(10, at(100));
  pacer.setFactor(0.5, 11.2, at(100.5));  // 11 s are due
  EXPECT_NEAR(pacer.wait(11, at(100.5)), 0, kNanosecond);
  EXPECT_NEAR(pacer.wait(12, at(100.5)), 2, kNanosecond);
}

// "slower" would else first let time leap by what the old factor was too fast for
TEST(Pacer, DoesNotCatchUpAtAnotherFactorWhatHasFallenBehind) {
  Pacer pacer(7);
  pacer.restart(0, at(100));
  pacer.setFactor(0.5, 0.01, at(100.2));  // 1.4 s are due
  EXPECT_NEAR(pacer.wait(0.01, at(100.2)), 0, kNanosecond);
  EXPECT_NEAR(pacer.wait(0.11, at(100.2)), 0.2, kNanosecond);
}

TEST(Pacer, CountsFromTheTimeReachedAfterFactorZero) {
  Pacer pacer(0);
  pacer.restart(0, at(100));
  pacer.setFactor(4, 50, at(101));
  EXPECT_NEAR(pacer.wait(52, at(101)), 0.5, kNanosecond);
  pacer.setFactor(0, 50, at(101));
  EXPECT_LE(pacer.wait(1e9, at(101)), 0);
}

}  // namespace rigid_body_sim
