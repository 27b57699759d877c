#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// Bodies "box", "ball" and the fixed "table", complete in four lines; laws begin on line 6.
std::string sceneWith(const std::string& laws, const std::string& integrator = "auto") {
  return "time_step: 0.01\nbodies:\n"
         "  - {name: box, mass: 2, inertia: {ixx: 1, iyy: 2, izz: 2.5}, "
         "center_of_mass: [0, 0, 0.5]}\n"
         "  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1, position: [3, 0, 0]}\n"
         "  - {name: table, shape: {box: [1, 1, 1]}, mass: 1, fixed: true, position: [0, 0, -4]}\n"
         "integrator: " +
         integrator + "\nforces:\n  - " + laws + "\n";
}

std::string forceError(const std::string& law) { return errorOf(sceneWith(law)); }

struct Built {
  explicit Built(const std::string& text)
      : scene(parseScene(text, "s.yaml")),
        world(buildWorld(scene)),
        state(initialState(scene, world)) {}

  /// Of the laws and gravity, with every body at rest.
  double energy() const { return mechanicalEnergy(world, state); }
  Wrench wrenchOn(std::size_t body) const {
    std::vector<const Body*> bodies;
    for (const Body& b : world.bodies) bodies.push_back(&b);
    std::vector<Wrench> wrenches(bodies.size());
    for (const auto& law : world.laws) law->addWrenches({bodies, state.bodies}, wrenches);
    return wrenches[body];
  }

  Scene scene;
  World world;
  State state;
};

const std::string kAtForce = "s.yaml:8: forces[0]: ";
const std::string kSpring = "{type: spring, from: {body: box}, to: {world: [0, 0, 2]}, ";

}  // namespace

// From the box's own origin, half a metre below its centre of mass, to 2 m above: 40/2 (2 − 1)².
TEST(SceneSpring, ReachesFromABodyFrameToTheWorld) {
  const Built built(
      sceneWith("{type: spring, from: {body: box, point: [0, 0, 0]}, to: {world: [0, 0, 2]}, "
                "stiffness: 40, damping: 0.1, rest_length: 1.0}"));
  ASSERT_EQ(built.world.laws.size(), 1u);
  EXPECT_EQ(built.world.laws[0]->members(), std::vector<std::size_t>{0});
  EXPECT_NE(built.world.laws[0]->needs() & kDamping, 0u);
  EXPECT_NEAR(built.energy(), 20, 1e-14);
  EXPECT_LE((built.wrenchOn(0).f_W - Vector3d(0, 0, 40)).norm(), 1e-14);
}

TEST(SceneSpring, ReachesFromBodyToBody) {
  const Built built(
      sceneWith("{type: spring, from: {body: ball, point: [-1, 0, 0]}, to: {body: box}, "
                "stiffness: 3}"));
  EXPECT_EQ(built.world.laws[0]->needs() & kDamping, 0u);
  EXPECT_NEAR(built.energy(), 0.5 * 3 * 2 * 2, 1e-14);
  EXPECT_LE((built.wrenchOn(1).f_W - Vector3d(-6, 0, 0)).norm(), 1e-14);
}

TEST(SceneSpring, EndsInTheWorldOnAFixedBody) {
  const Built built(
      sceneWith("{type: spring, from: {body: box}, to: {body: table, point: [0, 0, 1]}, "
                "stiffness: 2}"));
  EXPECT_EQ(built.world.laws[0]->members(), std::vector<std::size_t>{0});
  EXPECT_NEAR(built.energy(), 0.5 * 2 * 3 * 3, 1e-14);
}

TEST(SceneSpring, KeepsItsRules) {
  EXPECT_EQ(forceError(kSpring + "stiffness: -1}"),
            kAtForce + "stiffness must be >= 0 N/m, got -1");
  EXPECT_EQ(forceError(kSpring + "stiffness: 1, damping: -2}"),
            kAtForce + "damping must be >= 0 N s/m, got -2");
  EXPECT_EQ(forceError(kSpring + "stiffness: 1, rest_length: -2}"),
            kAtForce + "rest_length must be >= 0 m, got -2");
  EXPECT_EQ(forceError(kSpring + "stiffness: stiff}"),
            kAtForce + "stiffness must be a number [N/m], got stiff");
  EXPECT_EQ(
      forceError(kSpring + "stifness: 1}"),
      kAtForce + "unknown key 'stifness' (known: type, from, to, stiffness, damping, rest_length)");
  EXPECT_EQ(forceError("{type: spring, from: {body: box}, to: {world: [0, 0, 2]}}"),
            kAtForce + "missing key 'stiffness'");
}

TEST(SceneSpring, JoinsTwoThings) {
  const auto endsError = [](const std::string& from, const std::string& to) {
    return forceError("{type: spring, stiffness: 1, from: " + from + ", to: " + to + "}");
  };
  EXPECT_EQ(endsError("{world: [0, 0, 1]}", "{world: [0, 0, 2]}"),
            kAtForce + "from and to must not both be fixed in the world");
  EXPECT_EQ(endsError("{body: table}", "{world: [0, 0, 2]}"),
            kAtForce + "from and to must not both be fixed in the world");
  EXPECT_EQ(endsError("{body: box}", "{body: box, point: [0, 0, 1]}"),
            kAtForce + "from and to must not be on one body, 'box'");
  EXPECT_EQ(endsError("{body: bx}", "{world: [0, 0, 1]}"),
            kAtForce + "from.body must be one of box, ball, table, got 'bx'; did you mean 'box'?");
  const std::string rule =
      " must be {body: name, point: [x, y, z]} or {world: [x, y, z]}, got a mapping";
  EXPECT_EQ(endsError("{body: box, world: [0, 0, 1]}", "{body: ball}"), kAtForce + "from" + rule);
  EXPECT_EQ(endsError("{body: box}", "{}"), kAtForce + "to" + rule);
  EXPECT_EQ(endsError("{body: box}", "{world: [0, 0, 1], point: [0, 0, 1]}"),
            kAtForce + "to" + rule);
  EXPECT_EQ(endsError("{body: box}", "{world: [0, 0]}"),
            kAtForce + "to.world must be a list of 3 numbers [m], got [0, 0]");
}

// Bodies at rest 1.5 m apart, half a metre more than the tether is long: 40/2 · 0.5².
TEST(SceneTether, ReachesFromABodyFrameToAnother) {
  const Built built(sceneWith(
      "{type: tether, from: {body: box, point: [0, 0, 0]}, to: {body: ball, point: [-1.5, "
      "0, 0]}, stiffness: 40, damping: 0.1, length: 1}"));
  ASSERT_EQ(built.world.laws.size(), 1u);
  EXPECT_STREQ(built.world.laws[0]->name(), "tether");
  EXPECT_NE(built.world.laws[0]->needs() & kDamping, 0u);
  const Simulation sim(built.world, built.state);
  EXPECT_NEAR(mechanicalEnergy(built.world, sim.state()), 5, 1e-14);
}

TEST(SceneTether, KeepsItsRules) {
  const std::string tether = "{type: tether, from: {body: box}, to: {world: [0, 0, 2]}, ";
  EXPECT_EQ(forceError(tether + "stiffness: 0, length: 1}"),
            kAtForce + "stiffness must be > 0 N/m, got 0");
  EXPECT_EQ(forceError(tether + "stiffness: 1, length: -1}"),
            kAtForce + "length must be > 0 m, got -1");
  EXPECT_EQ(forceError(tether + "stiffness: 1, length: 1, damping: -2}"),
            kAtForce + "damping must be >= 0 N s/m, got -2");
  EXPECT_EQ(forceError(tether + "stiffness: 1}"), kAtForce + "missing key 'length'");
  EXPECT_EQ(
      forceError(tether + "stiffness: 1, length: 1, rest_length: 1}"),
      kAtForce + "unknown key 'rest_length' (known: type, from, to, stiffness, damping, length)");
  EXPECT_EQ(
      forceError("{type: tether, from: {body: box}, to: {body: box}, stiffness: 1, length: 1}"),
      kAtForce + "from and to must not be on one body, 'box'");
  EXPECT_EQ(errorOf(sceneWith(tether + "stiffness: 1, damping: 1, length: 1}", "strang")),
            "s.yaml:6: integrator must be auto or support damping, as body 'box' needs "
            "(semi_implicit_euler, rk4, dop853), got 'strang'");
}

TEST(SceneCentralGravity, ActsOnEveryBodyThatMoves) {
  const Built built(sceneWith("{type: central_gravity, center: [0, 0, 2.5], mu: 8}"));
  EXPECT_EQ(built.world.laws.size(), 2u);
  EXPECT_NEAR(built.energy(), -8 * 2 / 2.0 - 8 * 1 / std::sqrt(9 + 6.25), 1e-14);
  // on the axis of the box, with and without gradient: no torque; the force points to the centre
  EXPECT_LE((built.wrenchOn(0).f_W - Vector3d(0, 0, 8 * 2 / 4.0)).norm(), 1e-14);
  EXPECT_EQ(built.wrenchOn(2).f_W, Vector3d::Zero());
}

TEST(SceneCentralGravity, HasAGradientWhereAsked) {
  const std::string law = "{type: central_gravity, center: [1, 2, 3], mu: 8";
  EXPECT_EQ(Built(sceneWith(law + "}")).wrenchOn(0).tau_P, Vector3d::Zero());
  EXPECT_GT(Built(sceneWith(law + ", gradient: true}")).wrenchOn(0).tau_P.norm(), 0.01);
}

TEST(SceneCentralGravity, KeepsItsRules) {
  EXPECT_EQ(forceError("{type: central_gravity, mu: 0}"),
            kAtForce + "mu must be > 0 m^3/s^2, got 0");
  EXPECT_EQ(forceError("{type: central_gravity}"), kAtForce + "missing key 'mu'");
  EXPECT_EQ(forceError("{type: central_gravity, mu: 1, gradient: 1}"),
            kAtForce + "gradient must be true or false, got 1");
  EXPECT_EQ(forceError("{type: central_gravity, mu: 1, body: box}"),
            kAtForce + "unknown key 'body' (known: type, center, mu, gradient)");
}

TEST(SceneForces, AreOfAKnownType) {
  EXPECT_EQ(forceError("{type: magnet}"),
            kAtForce + "type must be one of central_gravity, contact, spring, tether, got magnet");
  EXPECT_EQ(forceError("{stiffness: 1}"), kAtForce + "missing key 'type'");
  EXPECT_EQ(forceError("7"), kAtForce + "a mapping is expected, got 7");
  EXPECT_EQ(errorOf(boxScene("forces: 3\n")), "s.yaml:6: forces must be a list of laws, got 3");
}

TEST(SceneDrag, IsThatOfItsBody) {
  const Built built(boxScene("    drag: {linear: 0.5, quadratic: 2, angular: 0.1}\n"));
  ASSERT_EQ(built.world.laws.size(), 1u);
  const auto& drag = dynamic_cast<const Drag&>(*built.world.laws[0]);
  EXPECT_EQ(drag.members(), std::vector<std::size_t>{0});
  EXPECT_EQ(drag.coefficients().linear, 0.5);
  EXPECT_EQ(drag.coefficients().quadratic, 2);
  EXPECT_EQ(drag.coefficients().angular, 0.1);
  EXPECT_TRUE(Built(boxScene()).world.laws.empty());
}

TEST(SceneDrag, KeepsItsRules) {
  const auto dragError = [](const std::string& drag) {
    return errorOf(boxScene("    drag: " + drag + "\n"));
  };
  const std::string at = "s.yaml:6: body 'box': ";
  EXPECT_EQ(dragError("{linear: -1}"), at + "drag.linear must be >= 0 N s/m, got -1");
  EXPECT_EQ(dragError("{quadratic: -1}"), at + "drag.quadratic must be >= 0 N s^2/m^2, got -1");
  EXPECT_EQ(dragError("{angular: -1}"), at + "drag.angular must be >= 0 N m s, got -1");
  EXPECT_EQ(dragError("{cubic: 1}"),
            at + "unknown key 'drag.cubic' (known: linear, quadratic, angular, center)");
}

TEST(SceneIntegrator, TakesWhatActsInTheScene) {
  const std::string spring = kSpring + "stiffness: 1}";
  EXPECT_EQ(
      errorOf(sceneWith(spring, "taylor")),
      "s.yaml:6: integrator must be auto or support laws or wrenches that couple bodies, as body "
      "'box' needs (semi_implicit_euler, strang, magnus4, rk4, blanes_moan6, kahan_li8, "
      "dop853), got 'taylor'");
  EXPECT_EQ(errorOf(sceneWith(spring, "strang")), "");
  EXPECT_EQ(errorOf(sceneWith(kSpring + "stiffness: 1, damping: 1}", "strang")),
            "s.yaml:6: integrator must be auto or support damping, as body 'box' needs "
            "(semi_implicit_euler, rk4, dop853), got 'strang'");
  EXPECT_EQ(errorOf("integrator: kahan_li8\n" + boxScene("    drag: {linear: 1}\n")),
            "s.yaml:1: integrator must be auto or support drag, as body 'box' needs "
            "(semi_implicit_euler, strang, magnus4, rk4, dop853), got 'kahan_li8'");
}

}  // namespace rigid_body_sim
