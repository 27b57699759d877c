#include <gtest/gtest.h>

#include "ros/inputs/refusals.hpp"

namespace rigid_body_sim {

TEST(Refusals, NameTheInputAndAreCountedTogether) {
  Refusals refusals;
  ::testing::internal::CaptureStderr();
  refusals.add("mouse feedback", "no such handle");
  const std::string warning = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(warning.find("mouse feedback refused (1 so far): no such handle"), std::string::npos)
      << warning;
  refusals.add("wrench", "no such body");
  EXPECT_EQ(refusals.count(), 2);
}

}  // namespace rigid_body_sim
