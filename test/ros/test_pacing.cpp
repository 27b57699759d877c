#include <vector>

#include <gtest/gtest.h>

#include "ros/clock/pacer.hpp"
#include "ros/outputs/ticker.hpp"

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

TEST(Ticker, FallsOnEveryTenthStepOfAThousandthAtAHundredHertz) {
  const Ticker ticker(100, 0.001);
  std::vector<int> ticks;
  for (int n = 0; n <= 1000; ++n) {
    if (ticker.due(n * 0.001)) ticks.push_back(n);
  }
  ASSERT_EQ(ticks.size(), 101U);
  for (std::size_t k = 0; k < ticks.size(); ++k) EXPECT_EQ(ticks[k], 10 * static_cast<int>(k));
}

TEST(Ticker, FallsOnTheSameStepsWhicheverWereAsked) {
  const Ticker ticker(100, 0.001);
  EXPECT_FALSE(ticker.due(0.001));
  EXPECT_FALSE(ticker.due(0.009));
  EXPECT_TRUE(ticker.due(0.010));
  EXPECT_TRUE(ticker.due(0));
  EXPECT_TRUE(Ticker(1e-6, 0.001).due(0));
}

TEST(Ticker, FallsOnEveryStepThatIsLongerThanItsPeriod) {
  const Ticker ticker(100, 0.05);
  for (int n = 0; n < 10; ++n) EXPECT_TRUE(ticker.due(n * 0.05));
}

TEST(Ticker, FallsOnTheFirstStepThatReachesItsInstant) {
  const Ticker ticker(10, 0.03);  // 0, 0.1, 0.2 s
  std::vector<double> ticks;
  for (int n = 0; n < 8; ++n) {
    if (ticker.due(n * 0.03)) ticks.push_back(n);
  }
  EXPECT_EQ(ticks, (std::vector<double>{0, 4, 7}));  // 0, 0.12, 0.21 s
}

}  // namespace rigid_body_sim
