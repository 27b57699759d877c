#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/InteractiveMarkerInit.h>

#include <rigid_body_sim/BodyStates.h>
#include <rigid_body_sim/SetMassProperties.h>
#include <rigid_body_sim/SetPresent.h>
#include <rigid_body_sim/StateFile.h>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "live_node.hpp"
#include "ros/inputs/input_replay.hpp"
#include "ros/inputs/state_requests.hpp"
#include "support/temporary_directory.hpp"

/// Bodies that become others, leave and come in while the node runs.
namespace rigid_body_sim {
namespace {

class LiveBodies : public LiveNode {
 protected:
  LiveBodies() { driver.connect(); }
  ~LiveBodies() override { driver.reset(); }

  void file(const std::string& service, const std::string& name) const {
    StateFile::Request request;
    request.path = directory.path(name);
    EXPECT_TRUE(call<StateFile>(service, request).success);
  }

  /// A state that is loaded begins a record.
  void beginRecord() {
    file("save", "start.state");
    while (inputs.empty()) {
      file("load", "start.state");
      NodeDriver::waitFor([&] { return !inputs.empty(); }, 0.1);
    }
  }

  /// The box in the run that the recorded inputs lead to, so many steps after the record began.
  GetState::Response repeatedBox(std::int64_t steps) {
    const std::size_t count = inputs.size();
    NodeDriver::waitFor([&] { return inputs.size() > count; }, 0.1);  // what is on its way
    const Scene scene = loadScene(RIGID_BODY_SIM_TEST_SCENE);
    const World world = buildWorld(scene);
    Simulation sim(world, initialState(scene, world));
    InputReplay replay(lastRun(inputs, world, "world"));
    replay.applyDue(sim);
    const std::int64_t end = sim.steps() + steps;
    while (sim.steps() < end) {
      sim.step();
      replay.applyDue(sim);
    }
    EXPECT_TRUE(replay.isDone());
    GetState::Request request;
    request.body = "box";
    request.frame = "world";
    return reportState(request, sim.world(), sim.state(), "world");
  }

  /// The momenta of the box, to the last bit, as the node saves them.
  std::string savedMomenta(const std::string& name) const {
    file("save", name);
    std::ifstream state(directory.path(name));
    std::string momenta;
    bool is_box = false;
    for (std::string line; std::getline(state, line);) {
      if (line.find("  - name: ") == 0) is_box = line == "  - name: box";
      const bool is_momentum =
          line.find("    momentum: ") == 0 || line.find("    angular_momentum_world: ") == 0;
      if (is_box && is_momentum) momenta += line + "\n";
    }
    return momenta;
  }

  std::string setPresent(const SetPresent::Request& request) const {
    return call<SetPresent>("set_present", request).message;
  }

  std::set<std::string> namesOfHandles() const {
    std::set<std::string> names;
    for (const auto& marker : handles.markers) names.insert(marker.name);
    return names;
  }

  /// What who subscribes to /tf_static now is sent by the node.
  std::set<std::string> staticFrames() {
    std::set<std::string> frames;
    const ros::Subscriber late = nh.subscribe<tf2_msgs::TFMessage>(
        "/tf_static", 10,
        boost::function<void(const tf2_msgs::TFMessage&)>([&](const tf2_msgs::TFMessage& message) {
          for (const auto& transform : message.transforms) frames.insert(transform.child_frame_id);
        }));
    EXPECT_TRUE(NodeDriver::waitFor([&] { return frames.count("post") == 1; }));
    return frames;
  }

  TemporaryDirectory directory;
  std::vector<Input> inputs;
  BodyStates states;
  visualization_msgs::InteractiveMarkerInit handles;
  ros::NodeHandle nh;
  ros::Subscriber subscribers[3] = {
      nh.subscribe<Input>("rigid_body_node/inputs", 100,
                          boost::function<void(const Input&)>(
                              [this](const Input& input) { inputs.push_back(input); })),
      nh.subscribe<BodyStates>("rigid_body_node/states", 10,
                               boost::function<void(const BodyStates&)>(
                                   [this](const BodyStates& now) { states = now; })),
      nh.subscribe<visualization_msgs::InteractiveMarkerInit>(
          "rigid_body_node/push/update_full", 10,
          boost::function<void(const visualization_msgs::InteractiveMarkerInit&)>(
              [this](const auto& all) { handles = all; }))};
};

void expectSameBox(const GetState::Response& a, const GetState::Response& b) {
  EXPECT_EQ(a.pose, b.pose);
  EXPECT_EQ(a.twist, b.twist);
}

/// Twice the mass of the box, with its centre along x.
SetMassProperties::Request heavierBox(double x) {
  SetMassProperties::Request request;
  request.body = "box";
  request.inertia.m = 4;
  request.inertia.com.x = x;
  request.inertia.com.y = -0.2;
  request.inertia.com.z = 0.1;
  request.inertia.ixx = request.inertia.iyy = request.inertia.izz = 2;
  return request;
}

SetPresent::Request boxAt(double x) {
  SetPresent::Request request;
  request.body = "box";
  request.present = true;
  request.frame = "world";
  request.pose.position.x = x;
  request.pose.orientation.w = 1;
  request.twist.linear.z = 3;
  return request;
}

}  // namespace

TEST_F(LiveBodies, KeepTheirMomentaToTheLastBitWhenTheirMassIsSet) {
  driver.step(3);
  const std::string before = savedMomenta("before.state");
  EXPECT_EQ(std::count(before.begin(), before.end(), '\n'), 2);
  const GetState::Response was = boxNow();
  const SetMassProperties::Response answer =
      call<SetMassProperties>("set_mass_properties", heavierBox(0.3));
  EXPECT_EQ(answer.message, "");
  EXPECT_NE(answer.energy_change, 0);
  EXPECT_EQ(savedMomenta("after.state"), before);
  EXPECT_NE(boxNow().twist, was.twist);
}

TEST_F(LiveBodies, ThatBecomeOthersAreRecordedRepeatedSavedAndLoaded) {
  beginRecord();
  EXPECT_EQ(call<SetMassProperties>("set_mass_properties", heavierBox(0.5)).message, "");
  driver.step(30);
  expectSameBox(repeatedBox(30), boxNow());
  file("save", "heavy.state");
  driver.step(10);
  const GetState::Response end = boxNow();
  file("load", "heavy.state");
  driver.step(10);
  expectSameBox(boxNow(), end);
}

TEST_F(LiveBodies, ThatLeaveAndComeInAreRecordedRepeatedSavedAndLoaded) {
  beginRecord();
  SetPresent::Request leave;
  leave.body = "box";
  EXPECT_EQ(setPresent(leave), "");
  file("save", "away.state");
  EXPECT_EQ(setPresent(boxAt(7)), "");
  driver.step(30);
  const GetState::Response end = boxNow();
  expectSameBox(repeatedBox(30), end);
  file("load", "away.state");
  EXPECT_EQ(boxNow().message, "body 'box' is absent");
  EXPECT_EQ(setPresent(boxAt(7)), "");
  driver.step(30);
  expectSameBox(boxNow(), end);
}

TEST_F(LiveBodies, ComeBackWithAStateOfThePastWhileTimeStands) {
  std::vector<ros::Time> stamps;
  const ros::Subscriber tf = nh.subscribe<tf2_msgs::TFMessage>(
      "/tf", 100,
      boost::function<void(const tf2_msgs::TFMessage&)>([&](const tf2_msgs::TFMessage& message) {
        for (const auto& transform : message.transforms)
          if (transform.child_frame_id == "box") stamps.push_back(transform.header.stamp);
      }));
  driver.step(1);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return !stamps.empty(); }));
  SetPresent::Request leave;
  leave.body = "box";
  Step::Request five;
  five.steps = 5;
  file("save", "here.state");
  const GetState::Response here = boxNow();
  EXPECT_EQ(setPresent(leave), "");
  EXPECT_TRUE(call<Step>("step", five).success);
  file("load", "here.state");
  expectSameBox(boxNow(), here);
  EXPECT_TRUE(NodeDriver::waitFor([&] { return stamps.size() > 1; }));
  driver.step(5);
  EXPECT_EQ(setPresent(leave), "");
  EXPECT_TRUE(call<Step>("step", five).success);
  driver.reset();
  driver.step(5);
  EXPECT_EQ(std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()), stamps.end());
}

TEST_F(LiveBodies, RefuseMassPropertiesThatNoBodyCanHave) {
  SetMassProperties::Request request = heavierBox(0.5);
  request.inertia.izz = 9;
  EXPECT_EQ(call<SetMassProperties>("set_mass_properties", request).message,
            "body 'box': inertia must satisfy the triangle inequality I1 + I2 >= I3, got principal "
            "moments [2, 2, 9] kg m^2: 4 < 9");
  request.body = "post";
  request.inertia.izz = 2;
  EXPECT_EQ(call<SetMassProperties>("set_mass_properties", request).message,
            "body 'post' is fixed, nothing can move it");
}

TEST_F(LiveBodies, AreOnNoTopicWhileTheyAreAbsent) {
  ASSERT_TRUE(NodeDriver::waitFor(
      [&] { return states.name.size() == 3 && namesOfHandles().count("box") == 1; }));
  SetPresent::Request leave;
  leave.body = "box";
  EXPECT_EQ(setPresent(leave), "");
  EXPECT_EQ(setPresent(leave), "body 'box' is absent already");
  EXPECT_EQ(boxNow().message, "body 'box' is absent");
  const std::size_t received = driver.stamps().size();
  Step step;
  step.request.steps = 5;
  EXPECT_TRUE(ros::service::call("rigid_body_node/step", step));
  EXPECT_TRUE(NodeDriver::waitFor([&] { return states.header.stamp == step.response.stamp; }));
  EXPECT_EQ(states.name, (std::vector<std::string>{"canary", "post"}));
  EXPECT_TRUE(NodeDriver::waitFor([&] { return driver.transformsAtOnce() == 1; }));
  EXPECT_TRUE(NodeDriver::waitFor([&] { return namesOfHandles().count("box") == 0; }));
  EXPECT_EQ(driver.stamps().size(), received);  // nothing of the box
  EXPECT_EQ(staticFrames(), (std::set<std::string>{"post", "post/top"}));

  EXPECT_EQ(setPresent(boxAt(7)), "");
  EXPECT_EQ(staticFrames(), (std::set<std::string>{"box/tip", "post", "post/top"}));
  EXPECT_EQ(boxNow().pose.position, boxAt(7).pose.position);
  EXPECT_NEAR(boxNow().pose.orientation.w, 1, 1e-15);  // by way of the principal axes
  driver.step(5);
  EXPECT_TRUE(NodeDriver::waitFor(
      [&] { return states.name.size() == 3 && namesOfHandles().count("box") == 1; }));
  EXPECT_NEAR(driver.motion("box").position.x(), 7 + 0.5 * 0.1 * 0.05 * 0.05, 1e-9);
}

}  // namespace rigid_body_sim
