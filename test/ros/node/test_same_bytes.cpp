#include <algorithm>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>

#include <rigid_body_sim/Step.h>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "message_bytes.hpp"
#include "node_driver.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kSpan = 0.4;  // [s] that every pace tells: wrenches start and end in it

/// Messages to compare: half of the ten ticks of the span. At the fastest pace a queue may drop
/// some of these; later ones then stand in.
constexpr std::size_t kFewest = 5;

/// Namespace, which says how many bodies, and the node in it, which says at which pace.
struct Pace {
  const char* bodies;
  const char* name;
};

void PrintTo(const Pace& pace, std::ostream* out) { *out << pace.bodies << ", " << pace.name; }

/// The first body whose motion differs, in words.
std::string differenceOf(const BodyStates& message, const BodyStates& expected) {
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(message.name.size(), expected.name.size()); ++i) {
    if (message.pose[i] == expected.pose[i] && message.twist[i] == expected.twist[i]) continue;
    text << message.name[i] << "\n"
         << message.pose[i] << message.twist[i] << "instead of\n"
         << expected.pose[i] << expected.twist[i];
    return text.str();
  }
  text << "the bodies move alike; " << message.name.size() << " of " << expected.name.size();
  return text.str();
}

/// All bodies of the run now, fixed ones too.
BodyStates messageOf(const Simulation& run, const std::string& world_frame,
                     const ros::Time& stamp) {
  std::vector<std::size_t> all(run.world().bodies.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  BodyStates message = emptyBodyStates(run.world(), all, world_frame);
  setBodyStates(run.world(), all, run.bodies(), stamp, message);
  return message;
}

class SameBytes : public ::testing::TestWithParam<Pace> {
 protected:
  SameBytes() : node(std::string("/") + GetParam().bodies + "/" + GetParam().name + "/") {
    const boost::function<void(const BodyStates&)> receive = [this](const BodyStates& message) {
      received.push_back(message);
    };
    subscriber = nh.subscribe<BodyStates>(node + "states", 100000, receive);
    EXPECT_TRUE(ros::service::waitForService(node + "step", 20000));
    // steps until it is received; no wrench acts so soon
    origin.start = step(0);
    EXPECT_TRUE(NodeDriver::waitFor([this] {
      const ros::Time stamp = step(1);
      return NodeDriver::waitFor(
          [&] { return !received.empty() && received.back().header.stamp == stamp; }, 0.05);
    }));
  }

  ros::Time step(std::uint32_t steps) {
    Step call;
    call.request.steps = steps;
    EXPECT_TRUE(ros::service::call(node + "step", call));
    return call.response.stamp;
  }

  void pause(bool paused) {
    std_srvs::SetBool call;
    call.request.data = paused;
    EXPECT_TRUE(ros::service::call(node + "pause", call));
  }

  bool hasReached(double t) const {
    return !received.empty() && received.back().header.stamp >= origin.stamp(t);
  }

  const std::string node;
  ros::NodeHandle nh;
  ros::Subscriber subscriber;
  std::vector<BodyStates> received;
  TimeOrigin origin;
};

}  // namespace

TEST_P(SameBytes, ArePublishedAtEveryPace) {
  if (GetParam().name == std::string("stepped")) {
    for (std::uint32_t steps : {1U, 99U, 7U, 150U, 200U}) step(steps);
    ASSERT_TRUE(NodeDriver::waitFor([this] { return hasReached(kSpan); }));
  } else {
    pause(false);
    ASSERT_TRUE(
        NodeDriver::waitFor([this] { return hasReached(kSpan) && received.size() > kFewest; }));
    pause(true);
  }

  std::string text;
  ASSERT_TRUE(ros::param::get(node + "scene", text));
  const Scene scene = parseScene(text, "~scene");
  const World world = buildWorld(scene);
  Simulation run(world, initialState(scene, world));
  std::size_t compared = 0;
  for (const BodyStates& message : received) {
    const ros::Time stamp = message.header.stamp;
    if (stamp > origin.stamp(kSpan) && compared >= kFewest) break;
    while (origin.stamp(run.time()) < stamp) run.step();
    const BodyStates expected = messageOf(run, scene.world_frame, stamp);
    ASSERT_TRUE(bytesOf(message) == bytesOf(expected))
        << "at " << run.time() << " s, stamped " << stamp << ": "
        << differenceOf(message, expected);
    ++compared;
  }
  EXPECT_GE(compared, kFewest);
}

INSTANTIATE_TEST_SUITE_P(Paces, SameBytes,
                         ::testing::Values(Pace{"one", "real_time"}, Pace{"one", "ten_times"},
                                           Pace{"one", "fastest"}, Pace{"one", "stepped"},
                                           Pace{"hundred", "real_time"},
                                           Pace{"hundred", "ten_times"}, Pace{"hundred", "fastest"},
                                           Pace{"hundred", "stepped"}));

}  // namespace rigid_body_sim
