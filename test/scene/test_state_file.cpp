#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "support/same_state.hpp"
#include "support/temporary_directory.hpp"

/// Saved states keep every bit, and none is taken by a run that it is not of.
namespace rigid_body_sim {
namespace {

const std::string kSavedScene = R"(
time_step: 0.01
gravity: [0, 0, -9.81]
bodies:
  - name: ship
    mass: 2
    inertia: {ixx: 1, iyy: 1.5, izz: 2, ixy: 0.1}
    twist: {frame: world, angular: [0.1, 2, 0.3]}
    thrusters: {main: {limits: [0, 20], time_constant: 0.02}}
  - {name: other, shape: {box: [1, 2, 3]}, mass: 1, position: [5, 0, 0]}
  - {name: post, shape: {plane: {}}, fixed: true}
wrenches:
  - {body: other, frame: ship, force: [1, 2, 3], start: 0.1234, duration: 3}
)";

Simulation simulationOf(const Scene& scene) {
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

Simulation savedRun(const std::string& yaml = kSavedScene) {
  Simulation sim = simulationOf(parseScene(yaml, "scene.yaml"));
  PointWrench push;
  push.force = {1.0 / 3, 0, 1e-300};
  push.axes = push.point_frame = kOwnBody;
  push.end = 7;
  sim.applyWrench("id any bytes: \"%\\\n\xff", push);
  push.start = 2;
  push.end = INFINITY;
  sim.applyWrench("", push);
  ActuatorCommand command;
  command.value = 30;  // beyond the limit
  sim.command(command);
  command.start = 0.777;
  command.end = 0.888;
  sim.command(command);
  while (sim.steps() < 20) sim.step();
  return sim;
}

/// Why a text, changed from that of a saved run, is refused.
std::string refusalOf(std::string text, const World& world) {
  try {
    parseState(text, "x.state", world);
  } catch (const SceneError& fault) {
    return fault.what();
  }
  return "taken";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

/// Runs to `end`, at twenty random steps by way of a text and another run, and once without.
void expectSameBitsInParts(const Scene& scene, std::int64_t end) {
  Simulation whole = simulationOf(scene), parts = whole, other = whole;
  std::mt19937 random(static_cast<unsigned>(scene.bodies.size()));
  for (int k = 0; k < 20; ++k) {
    const std::int64_t cut = std::min(parts.steps() + static_cast<std::int64_t>(random() % 9), end);
    while (parts.steps() < cut) parts.step();
    const std::string text = stateText(parts.world(), parts.state());
    other.load(parseState(text, "parts", other.world()));
    std::swap(other, parts);
  }
  while (parts.steps() < end) parts.step();
  while (whole.steps() < end) whole.step();
  test::expectSameState(parts.state(), whole.state());
}

}  // namespace

TEST(StateFile, GivesBackEveryBit) {
  const Simulation sim = savedRun();
  const State state = sim.state();
  const std::string text = stateText(sim.world(), state);
  test::expectSameState(parseState(text, "text", sim.world()), state);
}

TEST(StateFile, OfEveryShippedSceneIsGoneOnFromInTwentyPartsWithTheSameBits) {
  for (const auto& file : std::filesystem::directory_iterator(RIGID_BODY_SIM_SCENES)) {
    if (file.path().extension() != ".yaml") continue;
    SCOPED_TRACE(file.path().string());
    expectSameBitsInParts(loadScene(file.path().string()), 100);
  }
}

TEST(StateFile, IsRefusedByAnotherScene) {
  const Simulation sim = savedRun();
  const std::string text = stateText(sim.world(), sim.state());
  const auto refusalIn = [&](const std::string& yaml) {
    return refusalOf(text, buildWorld(parseScene(yaml, "scene.yaml")));
  };
  EXPECT_EQ(refusalIn("# a comment\n" + kSavedScene), "taken");
  EXPECT_EQ(refusalIn(replaced(kSavedScene, "name: other", "name: thing")
                          .replace(kSavedScene.find("body: other"), 11, "body: thing")),
            "x.state:23: body 2 must be 'thing', as in this scene, got 'other': the state is of "
            "another scene");
  EXPECT_NE(refusalIn(replaced(kSavedScene, "start: 0.1234", "start: 0.12345"))
                .find("x.state:3: the state is of a scene with the same bodies and other values"),
            std::string::npos);
  EXPECT_EQ(refusalIn(replaced(kSavedScene, "mass: 2", "mass: 3")),
            "x.state:8: body 'ship': mass must be 3, as in this scene or in the files that it "
            "names, got 2");
  Scene finer = parseScene(kSavedScene, "scene.yaml");
  finer.time_step = 0.001;
  EXPECT_EQ(refusalOf(text, buildWorld(finer)),
            "x.state:4: solver.time_step must be 0.001, as in this run, got 0.01: the state is of "
            "another run");
}

TEST(StateFile, IsRefusedWhereItIsNotWhole) {
  const Simulation sim = savedRun();
  const std::string text = stateText(sim.world(), sim.state());
  const auto refusal = [&](const std::string& what, const std::string& by) {
    return refusalOf(replaced(text, what, by), sim.world());
  };
  EXPECT_EQ(refusal("version: 1", "version: 2"),
            "x.state:2: version must be 1, the version that this program reads, got 2");
  EXPECT_EQ(refusal("complete: true\n", ""),
            "x.state: is cut short: its last key, complete, is missing");
  EXPECT_EQ(refusal("complete: true", "complete: tru").find("x.state:"), 0U);
  EXPECT_NE(refusal("complete: true", "complete: false").find("must be true"), std::string::npos);
  const std::size_t at = text.find("\ntime: ") + 1;
  const std::string time = text.substr(at, text.find('\n', at) - at);
  for (const char* impossible : {"time: -1", "time: 1e+300"})
    EXPECT_NE(refusal(time, impossible).find("time must be from 0 to 2^53 time steps [s], got"),
              std::string::npos)
        << impossible;
  EXPECT_EQ(refusal("mass: 2", "mass: .nan"),
            "x.state:8: body 'ship': mass must be a finite number [kg], got .nan");
  EXPECT_EQ(refusal("actuator: main", "actuator: side"),
            "x.state:22: body 'ship': commands[0].actuator must be an "
            "actuator of the body, got side");
  EXPECT_EQ(refusalOf(kSavedScene, sim.world()),
            "x.state:2: is no saved state: it must begin with version");
  for (std::size_t size = 0; size + 1 < text.size(); size += 97)
    EXPECT_NE(refusalOf(text.substr(0, size), sim.world()), "taken") << size;
}

// Loading such a text would drop the commands to come.
TEST(StateFile, IsNotWrittenWithoutSchedulesWhereOnlyCommandsAreScheduled) {
  const std::string commands = "commands: [{body: ship, actuator: main, value: 3, start: 1}]\n";
  const Simulation sim = simulationOf(
      parseScene(kSavedScene.substr(0, kSavedScene.find("wrenches:")) + commands, "scene.yaml"));
  State state = sim.state();
  EXPECT_FALSE(stateText(sim.world(), state).empty());
  state.schedules.clear();
  EXPECT_THROW(stateText(sim.world(), state), std::invalid_argument);
}

TEST(StateFile, TakesThePlaceOfAnotherOnlyOnceItIsWritten) {
  const TemporaryDirectory directory;
  const Simulation sim = savedRun();
  const std::string path = directory.written("a.state", "before");
  saveState(path, sim.world(), sim.state());
  test::expectSameState(loadState(path, sim.world()), sim.state());
  EXPECT_FALSE(std::filesystem::exists(path + ".unfinished"));

  State broken = sim.state();
  broken.bodies[0].p_W.x() = NAN;
  EXPECT_THROW(saveState(path, sim.world(), broken), std::invalid_argument);
  test::expectSameState(loadState(path, sim.world()), sim.state());
  EXPECT_THROW(saveState(directory.path("none/a.state"), sim.world(), sim.state()), SceneError);
  EXPECT_THROW(requireSavable(directory.path("none/a.state")), SceneError);
}

TEST(StateFile, LeavesWhatLiesAtThePlaceOfTheUnfinishedOne) {
  const TemporaryDirectory directory;
  const Simulation sim = savedRun();
  const std::string linked = directory.path("a.state"), beside = directory.path("b.state"),
                    other = directory.written("other", "kept"),
                    unfinished = directory.written("b.state.unfinished", "kept");
  std::filesystem::create_symlink(other, linked + ".unfinished");
  for (const std::string& path : {linked, beside}) {
    requireSavable(path);
    saveState(path, sim.world(), sim.state());
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(path)));
    test::expectSameState(loadState(path, sim.world()), sim.state());
  }
  for (const std::string& path : {other, unfinished}) {
    std::string kept;
    std::ifstream(path) >> kept;
    EXPECT_EQ(kept, "kept");
  }
  EXPECT_FALSE(std::filesystem::exists(unfinished + ".1"));
}

TEST(StateFile, NeitherTakesThePlaceOfADeviceNorOfALink) {
  namespace fs = std::filesystem;
  const TemporaryDirectory directory;
  const Simulation sim = savedRun();
  const std::string full = directory.path("full.state"), link = directory.path("link.state");
  fs::create_symlink("/dev/full", full);  // a link, that nothing may happen to the device
  EXPECT_THROW(saveState(full, sim.world(), sim.state()), SceneError);
  EXPECT_TRUE(fs::is_character_file(full));

  fs::create_symlink(directory.written("a.state", "before"), link);
  saveState(link, sim.world(), sim.state());
  EXPECT_TRUE(fs::is_symlink(link));
  test::expectSameState(loadState(directory.path("a.state"), sim.world()), sim.state());
}

}  // namespace rigid_body_sim
