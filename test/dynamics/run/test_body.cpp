#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {
namespace {

std::string refusal(const MassProperties& properties) {
  try {
    makeBody("crate", properties);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

// a program compiled for another instruction set sees the same structures
TEST(Body, HasOneLayoutWhateverTheInstructionSet) {
  EXPECT_EQ(alignof(Body), alignof(double));
  EXPECT_EQ(alignof(BodyState), alignof(double));
  EXPECT_EQ(alignof(BodyFrameMotion), alignof(double));
}

TEST(Body, RefusesImpossibleMassProperties) {
  const MassProperties possible{2, Vector3d::Zero(), Matrix3d::Identity()};
  EXPECT_EQ(refusal(possible), "");

  MassProperties without_mass = possible;
  without_mass.mass = 0;
  EXPECT_EQ(refusal(without_mass), "body 'crate': mass must be > 0 kg, got 0");

  MassProperties impossible = possible;
  impossible.I_Bcm.diagonal() = Vector3d(1, 2, 4);
  EXPECT_EQ(refusal(impossible),
            "body 'crate': inertia must satisfy the triangle inequality I1 + I2 >= I3, got "
            "principal moments [1, 2, 4] kg m^2: 3 < 4");
}

}  // namespace
}  // namespace rigid_body_sim
