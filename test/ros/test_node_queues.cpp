#include <thread>

#include <gtest/gtest.h>

#include "ros/node/node_queues.hpp"

namespace rigid_body_sim {
namespace {

struct CountedCall : ros::CallbackInterface {
  explicit CountedCall(int& count) : calls(count) {}
  CallResult call() override { return ++calls, Success; }
  int& calls;
};

/// [s] Far longer than a test may take: a wait that does not end fails by its time limit.
constexpr double kForEver = 1e6;

}  // namespace

TEST(NodeQueue, WaitsNoLongerThanUntilACallbackIsThere) {
  NodeQueue queue;
  int calls = 0;
  queue.addCallback(boost::make_shared<CountedCall>(calls), 0);
  queue.waitForCallback(kForEver);
  EXPECT_EQ(calls, 0);  // it is served by whoever waits, in his time
  queue.callAvailable();
  EXPECT_EQ(calls, 1);
  std::thread another([&] { queue.addCallback(boost::make_shared<CountedCall>(calls), 0); });
  queue.waitForCallback(kForEver);
  EXPECT_FALSE(queue.isEmpty());
  another.join();
}

TEST(NodeQueue, IsWokenUpByAQueueBesideIt) {
  NodeQueue queue;
  SideQueue beside(queue);
  int calls = 0;
  std::thread another([&] { beside.addCallback(boost::make_shared<CountedCall>(calls), 0); });
  queue.waitForCallback(kForEver);
  another.join();
  queue.callAvailable();
  EXPECT_EQ(calls, 0);
  beside.callAvailable();
  EXPECT_EQ(calls, 1);
}

TEST(NodeQueue, WaitsInVainNoLongerThanItIsTold) {
  NodeQueue queue;
  queue.waitForCallback(0);
  queue.waitForCallback(-1);
  EXPECT_TRUE(queue.isEmpty());
}

}  // namespace rigid_body_sim
