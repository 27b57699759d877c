#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene_texts.hpp"

/// The key `pivot`.
namespace rigid_body_sim {
namespace {

/// A body with these keys beside its mass properties, on lines 3 and 4; `rest` follows.
std::string armWith(const std::string& keys, const std::string& rest = "") {
  return "gravity: [0, 0, -10]\ntime_step: 0.01\nbodies:\n"
         "  - {name: arm, shape: {sphere: {radius: 0.1}}, mass: 2,\n     " +
         keys + "}\n" + rest;
}

std::string armError(const std::string& keys, const std::string& rest = "") {
  return errorOf(armWith(keys, rest));
}

}  // namespace

// The body starts as its pose says, turned by a quarter about z; about the point it has the inertia
// 2 (0.4 · 0.01 + 0.25).
TEST(ScenePivot, HoldsAPointOfTheBody) {
  const Scene scene =
      parseScene(armWith("pivot: {point: [0.3, 0, 0.4]}, position: [1, 2, 3],\n     "
                         "orientation: {rpy: [0, 0, 1.5707963267948966]}, twist: {frame: body, "
                         "angular: [0, 0, 2]}"),
                 "s.yaml");
  const World world = buildWorld(scene);
  const Body& body = world.bodies[0];
  const BodyState state = initialState(scene, world).bodies[0];
  EXPECT_TRUE(body.pivoted);
  EXPECT_LT((state.x_W - Vector3d(1, 2.3, 3.4)).norm(), 1e-15);
  EXPECT_EQ(state.p_W, Vector3d::Zero());
  EXPECT_NEAR(body.I(0), 0.008, 1e-16);
  EXPECT_NEAR(body.I(2), 0.508, 1e-15);
  EXPECT_NEAR(body.com_P.norm(), 0.5, 1e-15);
  const BodyFrameMotion start = toBodyFrameMotion(body, state);
  EXPECT_LT((start.v_W - Vector3d(0.6, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(describeSolution(Simulation(world, initialState(scene, world)))[0],
            "arm: gravity, pivot, Taylor");
}

TEST(ScenePivot, RefusesWhatContradictsIt) {
  const std::string at = "s.yaml:5: body 'arm': ";
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1]}, fixed: true"),
            at +
                "pivot cannot stand beside fixed: true, for a fixed body does not turn; remove one "
                "of them");
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1]}, twist: {frame: body, linear: [1, 0, 0]}"),
            at + "twist.linear must be left out beside pivot, for the pivot stays where it is, got "
                 "[1, 0, 0] m/s");
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1]}, twist: {frame: body, linear: [0, 0, 0]}"),
            at + "twist.linear must be left out beside pivot, for the pivot stays where it is, got "
                 "[0, 0, 0] m/s");
  EXPECT_EQ(armError("pivot: {point: [0, 1e200, 0]}"),
            at + "pivot.point must be so near that the inertia about it is finite, got [0, 1e+200, "
                 "0] m");
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1e9]}"),
            at +
                "pivot.point must be so near that the body's own inertia is not lost in that about "
                "it, up to 2e+18 kg m^2, got [0, 0, 1e+09] m");
}

TEST(ScenePivot, RefusesWhatIsNotSupportedBesideIt) {
  const std::string at = "s.yaml:5: body 'arm': ";
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1]}", "forces: [{type: central_gravity, mu: 1}]\n"),
            at + "pivot is not supported beside central_gravity");
  EXPECT_EQ(armError("pivot: {point: [0, 0, 1]}",
                     "  - {name: ground, shape: {plane: {}}, fixed: true}\n"
                     "forces: [{type: contact, between: [arm, ground], stiffness: 1.0e+5}]\n"),
            "s.yaml:7: forces[0]: between: body 'arm' is on a pivot, and contact of such a body is "
            "not supported; remove its pivot or leave it out of between");
}

TEST(ScenePivot, IsTakenFromContactWithAllByNoCollision) {
  const std::string keys = "pivot: {point: [0, 0, 1]}";
  const auto world = [](const std::string& named) {
    return "  - {name: ground, shape: {plane: {}}, fixed: true}\n"
           "  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 1, position: [5, 0, 1]}\n"
           "forces: [{type: contact, between: [" +
           named + ", all], stiffness: 1.0e+5}]\n";
  };
  const std::string fault =
      "s.yaml:8: forces[0]: between: body 'arm' is on a pivot, and contact of such a body is not "
      "supported; remove its pivot or ";
  EXPECT_EQ(armError(keys, world("ground")),
            fault + "take it from what all means, by collision: []");
  EXPECT_EQ(armError(keys, world("arm")), fault + "leave it out of between");
  EXPECT_EQ(armError(keys + ", collision: []", world("ground")), "");
}

// −c v at the centre of mass, which moves at ω × c: here 3 m below the pivot.
TEST(ScenePivot, LetsDragActAtTheCentreOfMass) {
  const Scene scene =
      parseScene(armWith("pivot: {point: [0, 0, 3]}, drag: {linear: 0.5, quadratic: 0.1},\n     "
                         "twist: {frame: world, angular: [2, 0, 0]}"),
                 "s.yaml");
  const World world = buildWorld(scene);
  const State state = initialState(scene, world);
  ASSERT_EQ(world.laws.size(), 1U);
  std::vector<double> own(world.laws[0]->stateCount());
  world.laws[0]->setStart(own.data());
  const std::vector<const Body*> bodies{&world.bodies[0]};
  std::vector<Wrench> wrenches(1);
  world.laws[0]->addWrenches({bodies, state.bodies, own.data()}, wrenches);
  const Vector3d f_W(0, -(0.5 + 0.1 * 6) * 6, 0);
  EXPECT_LT((wrenches[0].f_W - f_W).norm(), 1e-14);
  const Vector3d tau_W = wrenches[0].tau_W + rotate(state.bodies[0].q_WP, wrenches[0].tau_P);
  EXPECT_LT((tau_W - Vector3d(0, 0, -3).cross(f_W)).norm(), 1e-13);
}

TEST(ScenePivot, NeedsAPoint) {
  EXPECT_NE(armError("pivot: {}").find("point"), std::string::npos);
  EXPECT_NE(armError("pivot: {point: [0, 1]}").find("pivot.point must be"), std::string::npos);
}

}  // namespace rigid_body_sim
