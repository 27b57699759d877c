#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/GetState.h>
#include <rigid_body_sim/SetRealTimeFactor.h>
#include <rigid_body_sim/SimStatus.h>

#include "node_driver.hpp"

namespace rigid_body_sim {
namespace {

/// What a user changes about a node while it runs.
class LiveNode : public ::testing::Test {
 protected:
  template <class Service>
  static typename Service::Response call(const std::string& name,
                                         const typename Service::Request& request) {
    Service service;
    service.request = request;
    EXPECT_TRUE(ros::service::call("rigid_body_node/" + name, service));
    return service.response;
  }

  /// Returns the rule that the factor breaks; empty if none.
  static std::string setFactor(double factor) {
    SetRealTimeFactor::Request request;
    request.factor = factor;
    return call<SetRealTimeFactor>("set_real_time_factor", request).message;
  }

  static ros::Time now() {
    GetState::Request request;
    request.body = "box";
    request.frame = "world";
    return call<GetState>("get_state", request).stamp;
  }

  /// Wall time [s] until a state of this stamp has come, from `begin` on.
  double elapsedAt(const ros::Time& stamp, const ros::WallTime& begin) const {
    EXPECT_TRUE(NodeDriver::waitFor([&] { return driver.stamps().back() >= stamp; }));
    return (ros::WallTime::now() - begin).toSec();
  }

  NodeDriver driver{{"box", "canary"}};
};

constexpr double kTimerError = 1e-3;  // [s] wall clock of this test and steady clock of the node

}  // namespace

TEST_F(LiveNode, ChangesItsPaceWithoutALostInstantOrAJump) {
  driver.connect();
  const std::size_t first = driver.stamps().size();
  EXPECT_EQ(setFactor(0.5), "");  // paused
  const ros::Time start = now();
  ros::WallTime begin = ros::WallTime::now();
  driver.pause(false);
  EXPECT_GE(elapsedAt(start + ros::Duration(0.1), begin), 0.2 - kTimerError);

  EXPECT_EQ(setFactor(5), "");  // running
  EXPECT_LT(elapsedAt(start + ros::Duration(2), ros::WallTime::now()), 2);
  for (std::size_t i = first; i < driver.stamps().size(); ++i)
    ASSERT_NEAR((driver.stamps()[i] - driver.stamps()[i - 1]).toSec(), 0.01, 2e-9);

  EXPECT_EQ(setFactor(0), "");
  EXPECT_LT(elapsedAt(now() + ros::Duration(10), ros::WallTime::now()), 10);
  begin = ros::WallTime::now();
  EXPECT_EQ(setFactor(1), "");
  EXPECT_GE(elapsedAt(now() + ros::Duration(0.1), begin), 0.1 - kTimerError);
  driver.pause(true);
}

TEST_F(LiveNode, KeepsItsPaceWhenAskedForAnImpossibleOne) {
  EXPECT_EQ(setFactor(3), "");
  EXPECT_EQ(setFactor(-1), "factor must be a finite number >= 0, got -1");
  EXPECT_NE(setFactor(std::nan("")), "");
  EXPECT_NE(setFactor(std::numeric_limits<double>::infinity()), "");
  SimStatus status;
  const boost::function<void(const SimStatus&)> take = [&](const SimStatus& s) { status = s; };
  ros::NodeHandle nh;
  const ros::Subscriber subscriber = nh.subscribe<SimStatus>("rigid_body_node/status", 10, take);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return status.steps > 0; }));
  EXPECT_EQ(status.requested_real_time_factor, 3);
}

}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  ros::init(argc, argv, "test_live");
  ::testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_started;
  return RUN_ALL_TESTS();
}
