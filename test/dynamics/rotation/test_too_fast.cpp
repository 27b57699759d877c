#include <gtest/gtest.h>

#include "dynamics/run/solved_motion.hpp"
#include "support/worlds.hpp"

/// What is said of a motion whose series would not come to the end of a step.
namespace rigid_body_sim {

TEST(SolvedMotion, SaysWhatIsTooFastForAStep) {
  const Body body = test::principalBody("ball", 2, {0.1, 0.15, 0.2});
  const BodyState state = toBodyState(body, test::tumbling({1, 2, 8}, {3, 0, 4}));
  const Vector3d g_W(0, 0, -9.81);
  HeldWrench wrench;
  EXPECT_EQ(tooFastText({body, wrench, g_W, {}}, state, false),
            "the motion is too fast to be followed: it turns at 5 rad/s; a shorter time_step or "
            "slower turning, or less torque, is needed");
  MediumLoad load;
  load.angular_P = Vector3d(1, 0, 0).asDiagonal();
  wrench.medium = &load;
  EXPECT_EQ(tooFastText({body, wrench, g_W, {}}, state, true),
            "the motion is too fast to be followed: drag slows it down at 10/s; weaker drag is "
            "needed");
  load.lift_W = {0, 0, 1000};
  load.lift_arm_P = {1, 0, 0};  // √(1000 N · 1 m / 0.1 kg m²)
  EXPECT_EQ(tooFastText({body, wrench, g_W, {}}, state, false),
            "the motion is too fast to be followed: buoyancy turns it at 100 rad/s; a shorter "
            "time_step or less buoyancy, or a centre nearer to that of mass, is needed");
}

}  // namespace rigid_body_sim
