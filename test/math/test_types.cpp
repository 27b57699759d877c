#include <gtest/gtest.h>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {
namespace {

// more alignment than a number's would follow from the instruction set that the compiler is told
TEST(Types, NeedNoMoreAlignmentThanANumber) {
  EXPECT_EQ(alignof(Vector3d), alignof(double));
  EXPECT_EQ(alignof(Matrix3d), alignof(double));
  EXPECT_EQ(alignof(Quaterniond), alignof(double));
  EXPECT_EQ(alignof(Isometry3d), alignof(double));
  EXPECT_EQ(alignof(Quaternion<float>), alignof(float));
}

TEST(Types, ConvertToThoseOfEigenAndBack) {
  const Quaterniond q = Quaterniond(0.1, 0.2, -0.3, 0.9).normalized();
  const Eigen::Quaterniond aligned = q;
  const Quaterniond back = aligned;
  EXPECT_EQ(back.coeffs(), q.coeffs());

  Isometry3d X = Isometry3d::Identity();
  X.linear() = q.toRotationMatrix();
  X.translation() = Vector3d(1, 2, 3);
  const Eigen::Isometry3d aligned_X(X);
  EXPECT_EQ(Isometry3d(aligned_X).matrix(), X.matrix());
}

}  // namespace
}  // namespace rigid_body_sim
