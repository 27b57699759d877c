#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ros/outputs/instants.hpp"

namespace rigid_body_sim {

TEST(Instants, AreQuotientsThatDoNotDrift) {
  Instants instants(3);
  for (int k = 0; k < 100000; ++k) {
    ASSERT_EQ(instants.next(), k / 3.0);
    instants.passTo(instants.next());
  }
}

TEST(Instants, GoOnAfterATimeHoweverManyAreLeftOut) {
  Instants instants(100);
  instants.passTo(0.3);
  EXPECT_EQ(instants.next(), 0.31);
  instants.passTo(0.305);
  EXPECT_EQ(instants.next(), 0.31);
  instants.passTo(1e6);
  EXPECT_EQ(instants.next(), 100000001 / 100.0);
  EXPECT_EQ(Instants(1e-6).next(), 0);
  Instants nanoseconds(1e9);  // more of them than doubles count one by one
  nanoseconds.passTo(1e9);
  EXPECT_GT(nanoseconds.next(), 1e9);
}

TEST(Instants, BeginWithTheFirstThatIsNotPast) {
  for (const double rate : {0.7, 3.0, 100.0, 997.0, 1e9}) {
    for (int k = 0; k < 1000; ++k) {
      ASSERT_EQ(Instants(rate, k / rate).next(), k / rate) << rate << " " << k;
      const double later = std::nextafter(k / rate, 1e9);
      ASSERT_EQ(Instants(rate, later).next(), (k + 1) / rate) << rate << " " << k;
    }
  }
}

}  // namespace rigid_body_sim
