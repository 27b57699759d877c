#include <iomanip>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "support/same_state.hpp"

/// A body whose mass properties are set moves as one of a scene that has them from the start.
namespace rigid_body_sim {
namespace {

struct MassScene {
  const char* name;
  const char* keys;    // of the body, beside its mass properties
  const char* forces;  // and other keys of the scene
};

const MassScene kMassScenes[] = {
    {"Wrench", "points: {tip: {position: [0.5, 0, 0.2], orientation: {rpy: [1, 2, 3]}}}",
     "wrenches:\n  - {body: box, frame: box/tip, point_frame: box/tip, point: [0.1, 0, 0], force: "
     "[1, "
     "2, 3], torque: [0.1, 0, 0], start: 0.1, duration: 2}"},
    {"WrenchInAxesOfAnother", "",
     "wrenches:\n  - {body: other, frame: box, point_frame: box, point: [1, 0, 0], force: [1, 2, "
     "3], "
     "start: 0.1, duration: 2}"},
    {"Spring", "",
     "forces:\n  - {type: spring, from: {body: box, point: [0.5, 0, 0]}, to: {body: other, point: "
     "[0, 0, "
     "1]}, stiffness: 40, damping: 0.5, rest_length: 1}"},
    {"Tether", "",
     "forces:\n  - {type: tether, from: {world: [0, 0, 3]}, to: {body: box, point: [0.1, 0.2, "
     "0.3]}, "
     "stiffness: 400, damping: 5, length: 0.5}"},
    {"Drag", "drag: {linear: 0.3, quadratic: 0.2, angular: 0.1}", ""},
    {"DragAlongAxes",
     "drag: {linear: [0.3, 0.1, 0.2], quadratic: [0.2, 0, 0.1], angular: 0.1, center: [0.1, 0.2, "
     "0]}\n"
     "    buoyancy: {volume: 0.5, center: [0, 0, 0.3]}",
     "medium: {density: 1.2, velocity: [3, 0, 0]}"},
    {"DragAtTheCentreOfMass", "drag: {linear: [0.3, 0.1, 0.2]}",
     "medium: {density: 1.2, velocity: [3, 0, 0]}"},
    {"CentralGravity", "",
     "forces:\n  - {type: central_gravity, center: [0, 0, -5], mu: 100, gradient: true}"},
    {"ContactWithAPlane",
     "collision: [{shape: {box: [0.4, 0.3, 0.2]}}, {shape: {cylinder: {radius: 0.3, length: "
     "0.5}}}, "
     "{shape: {ellipsoid: [0.1, 0.2, 0.4]}, position: [0, 0.2, 0]}]",
     "forces:\n  - {type: contact, between: [box, ground], stiffness: 1.0e4, dissipation: 0.4}"},
    {"ContactOfBalls", "collision: [{shape: {sphere: {radius: 0.4}}, position: [0, 0, -0.3]}]",
     "forces:\n  - {type: contact, between: [box, other], stiffness: 1.0e4, dissipation: 0.4}"},
    {"Motors",
     "thrusters: {main: {position: [0, 0, -0.2], time_constant: 0.02}}\n"
     "    rotors: {lift: {position: [0.2, 0.2, 0], turns: cw, thrust: 8.5e-6, drag_torque: 1.4e-7, "
     "inertia: 6.0e-5, time_constant: 0.03}}\n"
     "    wheels: {roll: {axis: [1, 0, 0], inertia: 0.01, speed: 10}}",
     "commands:\n  - {body: box, actuator: main, value: 3}\n  - {body: box, actuator: lift, value: "
     "500}\n  - {body: box, actuator: roll, value: 0.1}"},
    {"Pivot", "pivot: {point: [0.1, 0, 0.4]}", ""}};

MassProperties heavierBox() {
  Matrix3d I;
  I << 1.3, -0.05, 0.1, -0.05, 1.1, 0.15, 0.1, 0.15, 1.8;
  return {3.5, {-0.1, 0.15, -0.2}, I};
}

MassProperties lighterBox() {
  Matrix3d I;
  I << 1.0, 0.1, -0.2, 0.1, 1.5, 0.05, -0.2, 0.05, 2.0;
  return {2, {0.3, -0.2, 0.1}, I};
}

std::string sceneText(const MassScene& scene, const MassProperties& box) {
  const Matrix3d& I = box.I_Bcm;
  const bool on_pivot = std::string(scene.keys).find("pivot") != std::string::npos;
  std::ostringstream text;
  text << std::setprecision(17) << "time_step: 0.01\nintegrator: dop853\ngravity: [0, 0, -9.81]\n"
       << "bodies:\n  - name: box\n    mass: " << box.mass << "\n    center_of_mass: ["
       << box.com_B.x() << ", " << box.com_B.y() << ", " << box.com_B.z()
       << "]\n    inertia: {ixx: " << I(0, 0) << ", iyy: " << I(1, 1) << ", izz: " << I(2, 2)
       << ", ixy: " << I(0, 1) << ", ixz: " << I(0, 2) << ", iyz: " << I(1, 2)
       << "}\n    position: [0, 0, 0.9]\n"
       << "    twist: {frame: world, " << (on_pivot ? "" : "linear: [1, -0.5, 0.3], ")
       << "angular: [0.5, -1, 2]}\n    " << scene.keys
       << "\n  - {name: other, shape: {sphere: {radius: 0.4}}, mass: 1.5, position: [0.2, 0, "
          "-0.8]}\n"
          "  - {name: ground, shape: {plane: {}}, fixed: true, position: [0, 0, 0]}\n"
       << scene.forces << "\n";
  return text.str();
}

Simulation runOfMassScene(const MassScene& scene, const MassProperties& box) {
  const Scene parsed = parseScene(sceneText(scene, box), "scene.yaml");
  const World world = buildWorld(parsed);
  return Simulation(world, initialState(parsed, world));
}

void stepMassScene(Simulation& sim, int steps) {
  for (int i = 0; i < steps; ++i) sim.step();
}

BodyFrameMotion boxMotion(const Simulation& sim) {
  return toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
}

class MassChangeOfScene : public testing::TestWithParam<MassScene> {};

INSTANTIATE_TEST_SUITE_P(Scenes, MassChangeOfScene, testing::ValuesIn(kMassScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace

TEST_P(MassChangeOfScene, MovesAsIfItHadHadThemFromTheStart) {
  Simulation changed = runOfMassScene(GetParam(), lighterBox());
  stepMassScene(changed, 30);
  Simulation left = changed;
  changed.setMassProperties(0, heavierBox());

  const World heavier = runOfMassScene(GetParam(), heavierBox()).world();
  State state = changed.state();
  const Vector3d p_W = state.bodies[0].p_W, L_W = state.bodies[0].L_W;
  state.bodies[0] = toBodyState(heavier.bodies[0], boxMotion(changed));
  EXPECT_LT((state.bodies[0].p_W - p_W).norm(), 1e-13);
  state.bodies[0].L_W = L_W;  // with what the wheels have
  state.changes.clear();
  state.schedules.clear();  // those of the scene
  state.anchors.clear();
  state.plans.clear();
  state.near_laws.clear();
  Simulation expected(heavier, state);

  stepMassScene(changed, 30);
  stepMassScene(expected, 30);
  stepMassScene(left, 30);
  const BodyFrameMotion a = boxMotion(changed), b = boxMotion(expected);
  EXPECT_LT((a.x_W - b.x_W).norm(), 1e-9);
  EXPECT_LT((a.v_W - b.v_W).norm(), 1e-8);
  EXPECT_LT((a.w_W - b.w_W).norm(), 1e-8);
  EXPECT_LT(a.q_WB.angularDistance(b.q_WB), 1e-9);
  EXPECT_LT((changed.body(1).x_W - expected.body(1).x_W).norm(), 1e-9);
  EXPECT_GT((a.w_W - boxMotion(left).w_W).norm(), 1e-3);
}

TEST_P(MassChangeOfScene, IsSavedAndGoesOnWithTheSameBits) {
  Simulation changed = runOfMassScene(GetParam(), lighterBox());
  Simulation fresh = changed;
  stepMassScene(changed, 15);
  changed.setMassProperties(0, heavierBox());
  stepMassScene(changed, 5);
  const std::string text = stateText(changed.world(), changed.state());
  fresh.load(parseState(text, "state", fresh.world()));
  test::expectSameState(fresh.state(), changed.state());
  stepMassScene(changed, 20);
  stepMassScene(fresh, 20);
  test::expectSameState(fresh.state(), changed.state());
  // and back in a run that has changed meanwhile
  changed.load(parseState(text, "state", changed.world()));
  stepMassScene(changed, 20);
  test::expectSameState(changed.state(), fresh.state());
}

TEST(MassChangeInAFile, KeepsAForceAtTheCentreOfMassThere) {
  Simulation changed = runOfMassScene(kMassScenes[0], lighterBox());
  Simulation fresh = changed;
  changed.applyWrench("held",
                      wrenchAtCenterOfMass(changed.world().bodies, 0, {1, 2, 3}, {0, 0, 0}));
  fresh.load(parseState(stateText(changed.world(), changed.state()), "state", fresh.world()));
  for (Simulation* sim : {&changed, &fresh}) {
    stepMassScene(*sim, 5);
    sim->setMassProperties(0, heavierBox());
    stepMassScene(*sim, 20);
  }
  test::expectSameState(fresh.state(), changed.state());
  ASSERT_EQ(fresh.activeWrenches(0).size(), 2U);
  EXPECT_TRUE(fresh.activeWrenches(0)[0].at_center || fresh.activeWrenches(0)[1].at_center);
}

TEST(MassChangeInAFile, ThatBreaksARuleIsRefusedInOneLine) {
  Simulation sim = runOfMassScene(kMassScenes[0], lighterBox());
  sim.setMassProperties(0, heavierBox());
  std::string text = stateText(sim.world(), sim.state());
  text.replace(text.find("mass: 3.5"), 9, "mass: -35");
  try {
    parseState(text, "run.state", sim.world());
    FAIL() << "was read";
  } catch (const std::exception& refused) {
    const std::string line = refused.what();
    EXPECT_NE(line.find(": body 'box': mass must be > 0 kg, got -35"), std::string::npos) << line;
    EXPECT_EQ(line.find("body 'box'"), line.rfind("body 'box'")) << line;  // named once
    EXPECT_EQ(std::string(refused.what()).rfind("run.state:", 0), 0U) << refused.what();
  }
}

}  // namespace rigid_body_sim
