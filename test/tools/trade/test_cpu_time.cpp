#include <gtest/gtest.h>

#include "tools/trade/cpu_time.hpp"

namespace rigid_body_sim {
namespace {

// One of ten is less than the work can take, and the greater ones were disturbed.
TEST(Undisturbed, LeavesOutTheLowestTenth) {
  EXPECT_EQ(undisturbed({25, 22, 90, 23, 12, 26, 24, 22.5, 40, 31}), 22);
}

TEST(Undisturbed, OfAFewIsTheLeast) {
  EXPECT_EQ(undisturbed({23, 22, 25}), 22);
  EXPECT_EQ(undisturbed({7}), 7);
}

}  // namespace
}  // namespace rigid_body_sim
