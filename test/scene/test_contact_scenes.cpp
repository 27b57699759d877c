#include <gtest/gtest.h>

#include "scene/build/contact_shape.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// Bodies on lines 3 to 9; contact laws follow from line 11.
std::string touchingScene(const std::string& laws) {
  return R"(time_step: 0.01
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - {name: wall, shape: {plane: {}}, fixed: true, orientation: [0, 0.7071067811865476, 0, 0.7071067811865476], position: [-5, 0, 0]}
  - {name: crate, shape: {box: [0.4, 0.3, 0.2]}, mass: 5, position: [0, 0, 1]}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [1, 0, 1]}
  - {name: pill, shape: {capsule: {radius: 0.1, length: 0.2}}, mass: 1, position: [2, 0, 1]}
  - {name: post, shape: {sphere: {radius: 0.1}}, mass: 1, position: [3, 0, 1], fixed: true}
  - {name: ghost, mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}}
forces:
)" + laws;
}

std::string lawError(const std::string& keys) {
  return errorOf(touchingScene("  - {type: contact, " + keys + "}\n"));
}

World worldOf(const std::string& laws) {
  return buildWorld(parseScene(touchingScene(laws), "s.yaml"));
}

ContactParameters parametersOf(const std::string& keys) {
  const Scene scene =
      parseScene(touchingScene("  - {type: contact, between: [ball, ground], stiffness: 2.0e+5, " +
                               keys + "}\n"),
                 "s.yaml");
  return std::get<ContactDef>(scene.forces[0].law).parameters;
}

/// Indices of the bodies that each law acts on, law by law.
std::vector<std::vector<std::size_t>> membersOf(const World& world) {
  std::vector<std::vector<std::size_t>> members;
  for (const auto& law : world.laws) members.push_back(law->members());
  return members;
}

using Members = std::vector<std::vector<std::size_t>>;

const std::string kLine = "s.yaml:11: forces[0]: ";
constexpr std::size_t kCrate = 2, kBall = 3, kPill = 4;

}  // namespace

TEST(ContactKeys, HaveDefaults) {
  const ContactParameters p = parametersOf("friction: 0.5");
  EXPECT_EQ(p.stiffness, 2e5);
  EXPECT_EQ(p.exponent, 1.5);
  EXPECT_EQ(p.dissipation, 0);
  EXPECT_EQ(p.friction, 0.5);
  EXPECT_EQ(p.breakaway, 1e-5);
  EXPECT_EQ(p.rolling_friction, 0);
}

TEST(ContactKeys, AreRead) {
  const ContactParameters p =
      parametersOf("exponent: 1, dissipation: 0.4, breakaway: 1.0e-4, rolling_friction: 0.001");
  EXPECT_EQ(p.exponent, 1);
  EXPECT_EQ(p.dissipation, 0.4);
  EXPECT_EQ(p.breakaway, 1e-4);
  EXPECT_EQ(p.rolling_friction, 0.001);
}

TEST(ContactKeys, TakeARestitutionAtASpeed) {
  // x(0.5) = 1.43275053327, x = d v
  EXPECT_NEAR(parametersOf("restitution: 0.5, at: 2").dissipation, 1.43275053327 / 2, 1e-11);
  EXPECT_EQ(parametersOf("restitution: 1, at: 2").dissipation, 0);
}

TEST(ContactKeys, SayHowMuchIsDissipatedOnce) {
  const std::string pair = "between: [ball, ground], stiffness: 1, ";
  EXPECT_EQ(lawError(pair + "restitution: 0.5, at: 1, dissipation: 0"),
            kLine + "restitution cannot stand beside dissipation, which it determines, got 0.5");
  EXPECT_EQ(lawError(pair + "restitution: 0.5"),
            kLine +
                "restitution needs at: the speed of approach [m/s] at which it is returned, "
                "got 0.5");
  EXPECT_EQ(lawError(pair + "at: 1"), kLine + "at goes with restitution, got 1");
  const std::string range =
      "restitution must be > 0 and <= 1 (0 would need an infinite dissipation; 0.01 comes near)";
  EXPECT_EQ(lawError(pair + "restitution: 0, at: 1"), kLine + range + ", got 0");
  EXPECT_EQ(lawError(pair + "restitution: 1.1, at: 1"), kLine + range + ", got 1.1");
  EXPECT_EQ(lawError(pair + "restitution: 0.5, at: 0"), kLine + "at must be > 0 m/s, got 0");
}

TEST(ContactKeys, KeepTheirRules) {
  const std::string pair = "between: [ball, ground], stiffness: ";
  EXPECT_EQ(lawError(pair + "0"), kLine + "stiffness must be > 0 N/m^exponent, got 0");
  EXPECT_EQ(lawError(pair + "-1"), kLine + "stiffness must be > 0 N/m^exponent, got -1");
  EXPECT_EQ(lawError(pair + "1, exponent: 0.5"), kLine + "exponent must be >= 1, got 0.5");
  EXPECT_EQ(lawError(pair + "1, dissipation: -1"), kLine + "dissipation must be >= 0 s/m, got -1");
  EXPECT_EQ(lawError(pair + "1, friction: -1"), kLine + "friction must be >= 0, got -1");
  EXPECT_EQ(lawError(pair + "1, breakaway: 0"), kLine + "breakaway must be > 0 m, got 0");
  EXPECT_EQ(lawError(pair + "1, rolling_friction: -1"),
            kLine + "rolling_friction must be >= 0 m, got -1");
  EXPECT_EQ(lawError("between: [ball, ground]"), kLine + "missing key 'stiffness'");
  EXPECT_EQ(lawError("stiffness: 1"), kLine + "missing key 'between'");
  EXPECT_EQ(lawError(pair + "1, bounce: 1"),
            kLine +
                "unknown key 'bounce' (known: type, between, stiffness, exponent, dissipation, "
                "restitution, at, friction, breakaway, rolling_friction)");
}

TEST(ContactPairs, AreTwoBodiesOrOneAndAll) {
  const std::string rule = "between must be [body, body] or [body, all]";
  const std::string k = ", stiffness: 1";
  EXPECT_EQ(lawError("between: ball" + k), kLine + rule + ", got ball");
  EXPECT_EQ(lawError("between: [ball]" + k), kLine + rule + ", got [ball]");
  EXPECT_EQ(lawError("between: [ball, ball]" + k),
            kLine + rule + ", of two bodies, got [ball, ball]");
  EXPECT_EQ(lawError("between: [all, ball]" + k),
            kLine + rule + ", of two bodies, got [all, ball]");
  EXPECT_EQ(lawError("between: [bal, ground]" + k),
            kLine +
                "between: unknown body 'bal' (known: ground, wall, crate, ball, pill, post, "
                "ghost); did you mean 'ball'?");
}

TEST(ContactPairs, ThatCannotTouchAreRefused) {
  const std::string k = ", stiffness: 1";
  const std::string possible =
      "between must be a body and a plane, or two bodies made of balls (sphere, capsule, as shape, "
      "parts or collision), got ";
  EXPECT_EQ(lawError("between: [crate, ball]" + k), kLine + possible + "'crate' and 'ball'");
  EXPECT_EQ(lawError("between: [post, crate]" + k), kLine + possible + "'crate' and 'post'");
  EXPECT_EQ(lawError("between: [ground, wall]" + k),
            kLine + "between must name a body that moves, but 'wall' and 'ground' are fixed");
  EXPECT_EQ(lawError("between: [ghost, ground]" + k),
            kLine +
                "between: body 'ghost' has no shape to touch by; give it one: collision: "
                "[{shape: ...}, ...]");
  EXPECT_EQ(lawError("between: [ball, pill], rolling_friction: 0.01" + k),
            kLine + "rolling_friction acts on planes only, but neither 'ball' nor 'pill' is one");
  EXPECT_EQ(lawError("between: [crate, all]" + k), kLine + possible + "'crate' and 'ball'");
}

TEST(ContactPairs, NamedTwiceAreRefused) {
  const std::string law = "  - {type: contact, between: [ball, ground], stiffness: 1}\n";
  const std::string again = "  - {type: contact, between: [ground, ball], stiffness: 1}\n";
  EXPECT_EQ(errorOf(touchingScene(law + again)),
            "s.yaml:12: forces[1]: between names a pair that an entry before it names, 'ground' "
            "and 'ball'");
  const std::string all = "  - {type: contact, between: [ground, all], stiffness: 1}\n";
  EXPECT_EQ(errorOf(touchingScene(all + all)),
            "s.yaml:12: forces[1]: between: an entry before it names 'ground' and all");
}

TEST(ContactPairs, AreAtMost200000) {
  std::string text = "time_step: 1\nbodies:\n";
  std::string laws = "forces:\n";
  for (int i = 0; i < 650; ++i) {
    const std::string name = "b" + std::to_string(i);
    text += "  - {name: " + name + ", shape: {sphere: {radius: 1}}, mass: 1}\n";
    laws += "  - {type: contact, between: [" + name + ", all], stiffness: 1}\n";
  }
  const std::string error = errorOf(text + laws);
  EXPECT_NE(error.find("the contacts of a scene must be between at most 200000 pairs of bodies"),
            std::string::npos)
      << error;
}

TEST(ContactPairs, OfOneAndAllAreThoseWithEveryShapeThatMoves) {
  const World world = worldOf("  - {type: contact, between: [ground, all], stiffness: 1}\n");
  EXPECT_EQ(membersOf(world), (Members{{kCrate}, {kBall}, {kPill}}));
  const World balls = worldOf(
      "  - {type: contact, between: [crate, ground], stiffness: 1}\n"
      "  - {type: contact, between: [crate, wall], stiffness: 1}\n"
      "  - {type: contact, between: [wall, all], stiffness: 1}\n");
  EXPECT_EQ(membersOf(balls), (Members{{kCrate}, {kCrate}, {kBall}, {kPill}}));
}

TEST(ContactPairs, OfAllYieldToThoseThatAreNamed) {
  Scene scene = parseScene(
      touchingScene(
          "  - {type: contact, between: [ground, all], stiffness: 1, rolling_friction: 1}\n"
          "  - {type: contact, between: [ball, ground], stiffness: 2}\n"
          "  - {type: contact, between: [ball, pill], stiffness: 3}\n"),
      "s.yaml");
  EXPECT_EQ(membersOf(buildWorld(scene)), (Members{{kCrate}, {kPill}, {kBall}, {kBall, kPill}}));
}

TEST(ContactPairs, OfAllNeedAPartner) {
  EXPECT_EQ(
      errorOf("time_step: 1\nbodies: [{name: a, shape: {box: [1, 1, 1]}, mass: 1}]\n"
              "forces: [{type: contact, between: [a, all], stiffness: 1}]\n"),
      "s.yaml:3: forces[0]: between: there is no other body that has a shape for 'a' to touch");
}

TEST(Contact, IsRefusedByIntegratorsWithoutEvents) {
  const std::string law = "  - {type: contact, between: [ball, ground], stiffness: 1}\n";
  EXPECT_EQ(errorOf("integrator: dop853\n" + touchingScene(law)), "");
  const std::string refused = errorOf("integrator: rk4\n" + touchingScene(law));
  EXPECT_EQ(refused.rfind("s.yaml:1: integrator must be auto or ", 0), 0U) << refused;
  EXPECT_NE(refused.find("dop853"), std::string::npos) << refused;
}

}  // namespace rigid_body_sim
