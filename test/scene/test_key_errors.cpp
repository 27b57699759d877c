#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// The scene of one body in which that body has just these lines, from line 3.
std::string bodyScene(const std::string& lines) { return "time_step: 0.01\nbodies:\n" + lines; }

}  // namespace

TEST(SceneKeys, MustBeKnown) {
  EXPECT_EQ(errorOf("timestep: 1\n"),
            "s.yaml:1: unknown key 'timestep' (known: world_frame, gravity, medium, time_step, "
            "integrator, "
            "tolerance, horizon, threads, bodies, forces, wrenches, commands)");
  EXPECT_EQ(
      boxError("    mas: 1\n"),
      kAtBox +
          "unknown key 'mas' (known: name, frame, shape, mass, density, inertia, center_of_mass, "
          "parts, particles, urdf, impossible_inertia, position, orientation, twist, pivot, drag, "
          "buoyancy, points, "
          "collision, thrusters, rotors, wheels, imus, fixed, absent, visual)");
  EXPECT_EQ(boxError("    twist: {fram: world}\n"),
            kAtBox + "unknown key 'twist.fram' (known: frame, linear, angular)");
  EXPECT_EQ(boxError("    points: {a: {pos: [0, 0, 0]}}\n"),
            kAtBox + "unknown key 'points.a.pos' (known: position, orientation)");
  EXPECT_EQ(
      boxError("    visual: {colour: 1}\n"),
      kAtBox + "unknown key 'visual.colour' (known: mesh, scale, position, orientation, color)");
  EXPECT_EQ(boxError("wrenches:\n  - {bodi: box}\n"),
            "s.yaml:7: wrenches[0]: unknown key 'bodi' (known: body, point, point_frame, frame, "
            "force, torque, start, duration)");
  EXPECT_EQ(errorOf(bodyScene("  - name: a\n    shape: {cube: 1}\n")),
            "s.yaml:4: body 'a': unknown key 'shape.cube' (known: box, sphere, cylinder, capsule, "
            "ellipsoid, cone, mesh, plane)");
}

TEST(SceneKeys, MustBeThere) {
  EXPECT_EQ(errorOf("bodies: []\n"), "s.yaml:1: missing key 'time_step'");
  EXPECT_EQ(errorOf("time_step: 1\n"), "s.yaml:1: missing key 'bodies'");
  EXPECT_EQ(errorOf(bodyScene("  - mass: 1\n")), "s.yaml:3: bodies[0]: missing key 'name'");
  EXPECT_EQ(boxError("    twist: {linear: [0, 0, 0]}\n"), kAtBox + "missing key 'twist.frame'");
  EXPECT_EQ(boxError("wrenches:\n  - {body: box, duration: 1}\n"),
            "s.yaml:7: wrenches[0]: missing key 'frame'");
  EXPECT_EQ(boxError("wrenches:\n  - {body: box, frame: box}\n"),
            "s.yaml:7: wrenches[0]: missing key 'duration'");
  EXPECT_EQ(errorOf(bodyScene("  - name: a\n    shape: {cylinder: {radius: 1}}\n")),
            "s.yaml:4: body 'a': missing key 'shape.cylinder.length'");
}

TEST(SceneKeys, SayOnceWhatABodyIsMadeOf) {
  const std::string box = "  - name: a\n    shape: {box: [1, 1, 1]}\n";
  const std::string given = "  - name: a\n    inertia: {ixx: 1, iyy: 1, izz: 1}\n";
  EXPECT_EQ(errorOf(bodyScene("  - name: a\n")),
            "s.yaml:3: body 'a': missing what the body is made of: shape, with mass or density; "
            "mass and inertia; parts; particles; or urdf");
  EXPECT_EQ(errorOf(bodyScene(box)),
            "s.yaml:3: body 'a': missing key 'mass' or 'density' of the shape");
  EXPECT_EQ(errorOf(bodyScene(box + "    mass: 1\n    density: 1\n")),
            "s.yaml:6: body 'a': density cannot stand beside mass, got 1");
  EXPECT_EQ(boxError("    inertia: {ixx: 1, iyy: 1, izz: 1}\n"),
            kAtBox + "inertia cannot stand beside shape, which gives it, got a mapping");
  EXPECT_EQ(boxError("    center_of_mass: [0, 0, 0]\n"),
            kAtBox + "center_of_mass cannot stand beside shape, which gives it, got [0, 0, 0]");
  EXPECT_EQ(errorOf(bodyScene(given)), "s.yaml:3: body 'a': missing key 'mass'");
  EXPECT_EQ(errorOf(bodyScene(given + "    density: 1\n")),
            "s.yaml:5: body 'a': density needs a shape, got 1");
  EXPECT_EQ(errorOf(bodyScene("  - name: a\n    shape: {}\n")),
            "s.yaml:4: body 'a': shape must name one shape, got 0");
  EXPECT_EQ(errorOf(bodyScene(
                "  - name: a\n    shape: {box: [1, 1, 1], sphere: {radius: 1}}\n    mass: 1\n")),
            "s.yaml:4: body 'a': shape must name one shape, got 2");
}

TEST(SceneKeys, AreNotRepeatedHoweverManyThereAre) {
  std::string points = "    points:\n";
  for (int i = 0; i < 100; ++i) points += "      p" + std::to_string(i) + ": {}\n";
  EXPECT_EQ(errorOf(boxScene(points)), "");
  EXPECT_EQ(errorOf(boxScene(points + "      p7: {}\n")), "s.yaml:107: key 'p7' is repeated");
  EXPECT_EQ(errorOf(boxScene(points + "      p99: {}\n")), "s.yaml:107: key 'p99' is repeated");
}

TEST(SceneKeys, TakeAToleranceWithAutoOnly) {
  EXPECT_EQ(errorOf("integrator: rk4\ntolerance: 1e-6\n" + boxScene()),
            "s.yaml:2: tolerance goes with integrator auto only, got integrator rk4");
  EXPECT_EQ(errorOf("integrator: auto\ntolerance: 1e-6\n" + boxScene()), "");
  EXPECT_EQ(errorOf("integrator: rk4\nhorizon: 3\n" + boxScene()), "");
}

TEST(SceneKeys, TakeNoMoreStepsThanADoubleCounts) {
  const std::string rest = "bodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n";
  EXPECT_EQ(errorOf("horizon: 1e300\ntime_step: 0.01\n" + rest),
            "s.yaml:2: time_step must divide the horizon of 1e+300 s into at most 2^53 steps, got "
            "0.01");
  EXPECT_EQ(errorOf("time_step: 1e-320\n" + rest),
            "s.yaml:1: time_step must divide the horizon of 10 s into at most 2^53 steps, got "
            "1e-320");
  EXPECT_EQ(errorOf("time_step: 1\nhorizon: 9007199254740992\n" + rest), "");
  EXPECT_NE(errorOf("time_step: 1\nhorizon: 9007199254740994\n" + rest), "");
}

TEST(SceneKeys, TakeAsManyThreadsAsAreWhole) {
  EXPECT_EQ(errorOf("threads: 1024\n" + boxScene()), "");
  for (const char* threads : {"0", "-1", "1.5", "1025", "many"})
    EXPECT_EQ(
        errorOf("threads: " + std::string(threads) + "\n" + boxScene()),
        "s.yaml:1: threads must be a whole number from 1 to 1024, got " + std::string(threads));
}

TEST(SceneKeys, NameAnIntegratorOfTheCatalogue) {
  for (const Method& method : catalogue())
    EXPECT_EQ(errorOf("integrator: " + std::string(method.name) + "\n" + boxScene()), "");
  const std::string error = errorOf("integrator: rk5\n" + boxScene());
  EXPECT_EQ(error.substr(0, 42), "s.yaml:1: integrator must be one of auto, ");
  EXPECT_EQ(error.substr(error.rfind(',')), ", got 'rk5'");
  EXPECT_EQ(errorOf("integrator: [rk4]\n" + boxScene()),
            "s.yaml:1: integrator must be a text, got [rk4]");
}

TEST(SceneNames, AreUnique) {
  EXPECT_EQ(boxError("  - name: box\n    shape: {box: [1, 1, 1]}\n    mass: 1\n"),
            "s.yaml:6: body 'box': name is taken, by the body on line 3");
  // the line of the name, not of the list item
  EXPECT_EQ(errorOf(bodyScene("  - mass: 1\n    shape: {box: [1, 1, 1]}\n    name: box\n"
                              "  - mass: 1\n    name: box\n    shape: {box: [1, 1, 1]}\n")),
            "s.yaml:7: body 'box': name is taken, by the body on line 5");
}

TEST(SceneNames, DifferFromTheWorldFrame) {
  EXPECT_EQ(errorOf(bodyScene("  - {name: world, shape: {sphere: {radius: 1}}, mass: 1}\n")),
            "s.yaml:3: body 'world': 'world' is the world frame's name");
  EXPECT_EQ(errorOf("world_frame: box/tip\n" + boxScene("    points: {tip: {}}\n")),
            "s.yaml:7: body 'box': points.tip: 'box/tip' is the world frame's name");
}

TEST(SceneNames, AreWordsOfLettersDigitsAndUnderscores) {
  for (const std::string name : {"1a", "_a", "a-b", "a/b", "\"a b\"", "\"\"", "\u00e9"})
    EXPECT_EQ(errorOf(bodyScene("  - name: " + name + "\n")),
              "s.yaml:3: bodies[0]: name must be a name [A-Za-z][A-Za-z0-9_]* of at most 255 "
              "bytes, got " +
                  name);
  EXPECT_EQ(boxError("    points: {a-b: {}}\n"),
            kAtBox + "points: 'a-b' must be a name [A-Za-z][A-Za-z0-9_]* of at most 255 bytes");
  EXPECT_EQ(errorOf("world_frame: /map\n" + boxScene()),
            "s.yaml:1: world_frame must be a frame name [A-Za-z][A-Za-z0-9_]*, parts joined by /, "
            "got /map");
}

}  // namespace rigid_body_sim
