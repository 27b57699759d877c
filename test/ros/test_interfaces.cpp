#include <gtest/gtest.h>

#include "ros/node/interfaces.hpp"

namespace rigid_body_sim {

TEST(Interfaces, NameTheTopicsOfAllBodiesOnce) {
  EXPECT_EQ(shortNames({"/node/states", "/box/odom", "/ball/odom", "/tf", "/box/wrench",
                        "/other/odom", "/nodes/x", "/box/imu/truth"},
                       "/node", {"box", "ball"}),
            (std::vector<std::string>{"/nodes/x", "/other/odom", "/tf", "<body>/imu/truth",
                                      "<body>/odom", "<body>/wrench", "~states"}));
}

}  // namespace rigid_body_sim
