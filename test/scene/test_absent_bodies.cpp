#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "support/same_state.hpp"

namespace rigid_body_sim {
namespace {

const std::string kGuestScene = R"(
time_step: 0.01
gravity: [0, 0, -9.81]
bodies:
  - {name: host, shape: {sphere: {radius: 0.4}}, mass: 2, position: [0, 0, 0.5]}
  - name: guest
    shape: {sphere: {radius: 0.4}}
    mass: 1
    absent: true
    thrusters: {main: {time_constant: 0.02}}
  - {name: ground, shape: {plane: {}}, fixed: true}
forces:
  - {type: contact, between: [host, all], stiffness: 1.0e4, dissipation: 0.4}
  - {type: spring, from: {body: host}, to: {body: guest}, stiffness: 40, rest_length: 1}
)";

Simulation guestRun() {
  const Scene scene = parseScene(kGuestScene, "scene.yaml");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

std::string faultWith(const std::string& more) {
  try {
    buildWorld(parseScene(kGuestScene + more, "scene.yaml"));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

void stepGuest(Simulation& sim, int steps) {
  for (int i = 0; i < steps; ++i) sim.step();
}

}  // namespace

TEST(AbsentBody, IsReadAndIsSavedWhereItHasComeIn) {
  Simulation sim = guestRun(), fresh = sim;
  EXPECT_TRUE(sim.world().bodies[1].absent);
  stepGuest(sim, 10);
  BodyFrameMotion motion;
  motion.x_W = {0, 0, 1.7};
  sim.apply(PresenceInput{1, motion});
  stepGuest(sim, 10);
  EXPECT_FALSE(sim.world().bodies[1].absent);
  const std::string text = stateText(sim.world(), sim.state());
  fresh.load(parseState(text, "state", fresh.world()));
  test::expectSameState(fresh.state(), sim.state());
  stepGuest(sim, 30);
  stepGuest(fresh, 30);
  test::expectSameState(fresh.state(), sim.state());

  sim.apply(PresenceInput{1, std::nullopt});
  stepGuest(sim, 5);
  const std::string without = stateText(sim.world(), sim.state());
  fresh.load(parseState(without, "state", fresh.world()));
  test::expectSameState(fresh.state(), sim.state());
  stepGuest(sim, 30);
  stepGuest(fresh, 30);
  test::expectSameState(fresh.state(), sim.state());
}

TEST(AbsentBody, IsNamedByNoScheduledWrenchOrCommand) {
  EXPECT_EQ(faultWith("wrenches: [{body: guest, frame: world, force: [1, 0, 0], duration: 1}]"),
            "scene.yaml:15: wrenches[0]: body 'guest' is absent, no wrench acts on it");
  EXPECT_NE(faultWith("wrenches: [{body: host, frame: guest, force: [1, 0, 0], duration: 1}]")
                .find("frame 'guest' is fixed to body 'guest', which is absent"),
            std::string::npos);
  EXPECT_NE(faultWith("commands: [{body: guest, actuator: main, value: 1}]")
                .find("body 'guest' is absent, and starts without commands"),
            std::string::npos);
}

TEST(AbsentBody, IsNotFixed) {
  try {
    buildWorld(
        parseScene("time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1, "
                   "fixed: true, absent: true}]",
                   "scene.yaml"));
    FAIL() << "was accepted";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("absent cannot stand beside fixed: true"),
              std::string::npos);
  }
}

TEST(AbsentBody, CanBeSavedWhereNoOtherMoves) {
  for (const char* how : {"absent: true", "fixed: true"}) {
    const Scene scene =
        parseScene("time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1, " +
                       std::string(how) + "}]",
                   "scene.yaml");
    const World world = buildWorld(scene);
    Simulation sim(world, initialState(scene, world));
    sim.step();
    const State again = parseState(stateText(world, sim.state()), "state", world);
    EXPECT_EQ(again.t, 1) << how;
    EXPECT_EQ(Simulation(world, again).time(), 1) << how;
  }
}

}  // namespace rigid_body_sim
