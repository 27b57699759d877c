#include <chrono>
#include <stdexcept>
#include <string>

#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>

#include "ros/inputs/lockstep.hpp"

/// When messages have their turn in lockstep. Two topics: a, which somebody takes, and b.
namespace rigid_body_sim {
namespace {

class LockstepTurns : public ::testing::Test {
 protected:
  static NodeOptions twoTopics(double period = 0.02, double timeout = 5) {
    NodeOptions options;
    options.lockstep = {"/a", "/b", "/a"};
    options.lockstep_period = period;
    options.lockstep_timeout = timeout;
    return options;
  }

  /// A message with that stamp [s] and content comes; `taken` shows its turn.
  void comes(const std::string& topic, double stamp, int content = 0) {
    geometry_msgs::PointStamped message;
    message.header.seq = ++count;
    message.header.stamp = ros::Time(stamp);
    message.point.x = content;
    lockstep.hold(topic, message,
                  [this, topic, content] { taken += topic + std::to_string(content) + " "; });
  }

  /// What is taken at the state with that stamp [s]; "waits" if not all has come.
  std::string takenAt(double state) {
    if (!lockstep.isWaiting()) lockstep.begin(ros::Time(state), now);
    if (!lockstep.hasAll()) return "waits";
    taken.clear();
    lockstep.takeAll();
    return taken;
  }

  Lockstep lockstep{twoTopics(), 0.01};
  Lockstep::Clock::time_point now = Lockstep::Clock::now();
  std::string taken;
  std::uint32_t count = 0;
};

}  // namespace

TEST_F(LockstepTurns, ComeOnceEachTopicHasBroughtAMessageNoEarlierThanTheState) {
  EXPECT_EQ(takenAt(1), "waits");
  comes("/b", 1, 1);
  EXPECT_EQ(takenAt(1), "waits");
  comes("/a", 0.99, 2);
  EXPECT_EQ(takenAt(1), "waits");
  comes("/a", 1, 3);
  EXPECT_EQ(takenAt(1), "/a2 /a3 /b1 ");
}

// a controller that stamps its commands ahead does not spare the node the next answer
TEST_F(LockstepTurns, AreOfOneAnswerEach) {
  comes("/a", 1.05, 1);
  comes("/a", 1.07, 2);
  comes("/b", 1, 1);
  EXPECT_EQ(takenAt(1), "/a1 /b1 ");
  comes("/b", 1.02, 2);
  EXPECT_EQ(takenAt(1.02), "/a2 /b2 ");
  comes("/b", 1.04, 3);
  comes("/a", 1.07, 3);  // another message for the same instant
  EXPECT_EQ(takenAt(1.04), "waits");
  comes("/a", 1.09, 4);
  EXPECT_EQ(takenAt(1.04), "/a3 /a4 /b3 ");
}

TEST_F(LockstepTurns, AreNotGivenToRepetitions) {
  for (int i = 0; i < 3; ++i) comes("/a", 1, 7);
  comes("/b", 1);
  EXPECT_EQ(takenAt(1), "/a7 /b0 ");
  comes("/a", 1, 7);
  comes("/b", 1.02);
  EXPECT_EQ(takenAt(1.02), "waits");
  comes("/a", 1.02, 7);
  EXPECT_EQ(takenAt(1.02), "/a7 /b0 ");
}

TEST_F(LockstepTurns, BeginAnewWithARun) {
  comes("/a", 9, 1);
  comes("/b", 9, 1);
  EXPECT_EQ(takenAt(9), "/a1 /b1 ");
  comes("/a", 9.02, 2);
  lockstep.restart();
  EXPECT_FALSE(lockstep.isWaiting());
  EXPECT_EQ(takenAt(0), "waits");
  comes("/a", 0, 1);
  comes("/b", 0, 1);
  EXPECT_EQ(takenAt(0), "/a1 /b1 ");
}

TEST_F(LockstepTurns, AreWaitedForNoLongerThanTheTimeout) {
  lockstep.begin(ros::Time(1.5), now);
  comes("/a", 2);
  EXPECT_NO_THROW(lockstep.checkPatience(now + std::chrono::milliseconds(4900)));
  lockstep.restartPatience(now + std::chrono::seconds(60));
  EXPECT_NO_THROW(lockstep.checkPatience(now + std::chrono::seconds(64)));
  try {
    lockstep.checkPatience(now + std::chrono::seconds(66));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(
        error.what(),
        "lockstep: a message on /b stamped 1.500000000 or later did not come within 5 s of "
        "wall time (~lockstep_timeout)");
  }
}

// whoever answers the state at hand does not end the wait then, and must be told why
TEST_F(LockstepTurns, SayWhatAMessageFarAheadHasMadeOfTheNext) {
  lockstep.begin(ros::Time(1), now);
  EXPECT_EQ(lockstep.missing(), "a message on /a stamped 1.000000000 or later");
  comes("/a", 1.5, 1);
  comes("/b", 1e9, 1);
  EXPECT_EQ(takenAt(1), "/a1 /b1 ");
  lockstep.begin(ros::Time(1.25), now);
  EXPECT_EQ(lockstep.missing(),
            "a message on /a stamped later than 1.500000000 (the stamp of the last one taken)");
  comes("/a", 1.75, 2);
  comes("/b", 1.25, 2);
  EXPECT_EQ(lockstep.missing(),
            "a message on /b stamped later than 1000000000.000000000 (the stamp of the last one "
            "taken, 1e+09 s ahead of simulation time: of another clock?)");
}

TEST_F(LockstepTurns, AreAtMultiplesOfThePeriod) {
  EXPECT_TRUE(lockstep.isDueAt(0));
  EXPECT_FALSE(lockstep.isDueAt(1));
  EXPECT_TRUE(lockstep.isDueAt(2));
  EXPECT_FALSE(Lockstep(NodeOptions(), 0.01).isDueAt(0));
  EXPECT_TRUE(Lockstep(twoTopics(0.3), 0.1).isDueAt(3));
  EXPECT_THROW(Lockstep(twoTopics(0.025), 0.01), ParameterError);
  EXPECT_THROW(Lockstep(twoTopics(0.001), 0.01), ParameterError);
}

// Time was set back while an answer was on its way.
TEST_F(LockstepTurns, AnswersToARunThatWasLeftAreDropped) {
  EXPECT_EQ(takenAt(1), "waits");
  comes("/b", 1, 1);
  lockstep.restart();
  EXPECT_EQ(takenAt(0.2), "waits");
  comes("/a", 1, 2);  // the answer to the state at 1 s
  comes("/b", 0.2, 3);
  EXPECT_EQ(takenAt(0.2), "waits");
  comes("/a", 0.2, 4);
  EXPECT_EQ(takenAt(0.2), "/a4 /b3 ");
  comes("/a", 0.22, 5);
  comes("/b", 0.22, 6);
  EXPECT_EQ(takenAt(0.22), "/a5 /b6 ");
}

TEST_F(LockstepTurns, ComeFromTheStartWhereNoAnswerWasMissingWhenTimeWasSetBack) {
  comes("/a", 1, 1);
  comes("/b", 1, 2);
  EXPECT_EQ(takenAt(1), "/a1 /b2 ");
  lockstep.restart();
  EXPECT_EQ(takenAt(1), "waits");
  comes("/a", 1, 1);
  comes("/b", 1, 2);
  EXPECT_EQ(takenAt(1), "/a1 /b2 ");
}

TEST_F(LockstepTurns, EndWithATopicThatFloodsTheNodeWithoutAnswering) {
  EXPECT_EQ(takenAt(1), "waits");
  for (int i = 0; i < 100000; ++i) comes("/a", 0, i);
  EXPECT_EQ(lockstep.fault(), "");
  comes("/a", 0, -1);
  EXPECT_EQ(lockstep.fault().find("lockstep: /a has brought 100000 messages"), 0U);
  EXPECT_THROW(lockstep.checkPatience(now), std::runtime_error);
}

}  // namespace rigid_body_sim
