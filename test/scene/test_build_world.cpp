#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {
namespace {

const std::string kScenes = RIGID_BODY_SIM_SCENES "/";

/// A scene of one body "box" with the given lines in its entry.
Scene sceneOf(const std::string& body_lines) {
  return parseScene("time_step: 0.01\nbodies:\n  - name: box\n" + body_lines, "test.yaml");
}

double energyOf(const Scene& scene) {
  const World world = buildWorld(scene);
  return kineticEnergy(world.bodies[0], initialState(scene, world).bodies[0]);
}

}  // namespace

// The published energies were computed from moments rounded to six decimals: half a unit of the
// last place, times ω²/2 over the axes of the spin.
TEST(BoxesScenes, HaveThePublishedEnergy) {
  EXPECT_NEAR(energyOf(loadScene(kScenes + "boxes_simple.yaml")), 5.001041625, 0.5e-6 * 0.125);
  EXPECT_NEAR(energyOf(loadScene(kScenes + "boxes_complex.yaml")), 368.5464125, 0.5e-6 * 12.51);
}

TEST(BuildWorld, TakesTheSolverFromTheScene) {
  const Scene scene = parseScene(
      "time_step: 0.02\nintegrator: auto\ntolerance: 1e-6\nhorizon: 3\n"
      "bodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n",
      "s");
  const World world = buildWorld(scene);
  EXPECT_EQ(world.solver.integrator, "auto");
  EXPECT_EQ(world.solver.time_step, 0.02);
  EXPECT_EQ(world.solver.tolerance, 1e-6);
  EXPECT_EQ(world.solver.horizon, 3);
  EXPECT_EQ(world.g_W, Vector3d::Zero());
  EXPECT_TRUE(world.wrenches.empty());
}

TEST(BuildWorld, TakesDensityForTheMassItGives) {
  const Body by_mass =
      buildWorld(sceneOf("    shape: {box: [1, 2, 0.5]}\n    mass: 3\n")).bodies[0];
  const Body by_density =
      buildWorld(sceneOf("    shape: {box: [1, 2, 0.5]}\n    density: 3\n")).bodies[0];
  EXPECT_EQ(by_density.mass, 3);
  EXPECT_EQ(by_density.I, by_mass.I);
}

TEST(BuildWorld, GivesTheShapeItsInertia) {
  const Body sphere =
      buildWorld(sceneOf("    shape: {sphere: {radius: 2}}\n    mass: 5\n")).bodies[0];
  EXPECT_EQ(sphere.I, Vector3d(8, 8, 8));
  const Body rod =
      buildWorld(sceneOf("    shape: {cylinder: {radius: 1, length: 3}}\n    mass: 2\n")).bodies[0];
  EXPECT_EQ(rod.I, Vector3d(1, 2, 2));  // m r²/2 along, m (3 r² + l²)/12 across
}

TEST(BuildWorld, ReadsEveryShapeWithItsOwnMeasures) {
  const auto shapeOf = [](const std::string& text) {
    const Scene scene = sceneOf("    shape: " + text + "\n    mass: 1\n");
    return std::get<Shape>(std::get<SolidDef>(scene.bodies[0].composition).geometry);
  };
  EXPECT_EQ(std::get<Box>(shapeOf("{box: [1, 2, 3]}")).size, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<Sphere>(shapeOf("{sphere: {radius: 2}}")).radius, 2);
  const Cylinder cylinder = std::get<Cylinder>(shapeOf("{cylinder: {length: 3, radius: 2}}"));
  EXPECT_EQ(cylinder.radius, 2);
  EXPECT_EQ(cylinder.length, 3);
  const Capsule capsule = std::get<Capsule>(shapeOf("{capsule: {radius: 2, length: 0}}"));
  EXPECT_EQ(capsule.radius, 2);
  EXPECT_EQ(capsule.length, 0);
  EXPECT_EQ(std::get<Ellipsoid>(shapeOf("{ellipsoid: [1, 2, 3]}")).semi_axes, Vector3d(1, 2, 3));
  const Cone cone = std::get<Cone>(shapeOf("{cone: {radius: 2, length: 3}}"));
  EXPECT_EQ(cone.radius, 2);
  EXPECT_EQ(cone.length, 3);
}

TEST(BuildWorld, KeepsTheSignOfProductsOfInertia) {
  const Scene scene = sceneOf(
      "    mass: 1\n    inertia: {ixx: 3, iyy: 4, izz: 5, ixy: 0.1, ixz: -0.2, iyz: 0.3}\n");
  Matrix3d I;
  I << 3, 0.1, -0.2,  //
      0.1, 4, 0.3,    //
      -0.2, 0.3, 5;
  EXPECT_EQ(std::get<MassProperties>(scene.bodies[0].composition).I_Bcm, I);
  const Body body = buildWorld(scene).bodies[0];
  const Matrix3d R = body.X_BP.linear();
  // a few Jacobi rotations, each of a few ulp
  EXPECT_LE((R * body.I.asDiagonal() * R.transpose() - I).cwiseAbs().maxCoeff(), 2e-14);
}

TEST(InitialState, PlacesTheCentreOfMassByTheBodyFrame) {
  // B turned by 90° about z: its x axis is the world's y
  const Scene scene = sceneOf(
      "    mass: 2\n    inertia: {ixx: 1, iyy: 1, izz: 1}\n    center_of_mass: [0.5, 0, 0]\n"
      "    position: [1, 2, 3]\n    orientation: [0, 0, 0.7071067811865476, 0.7071067811865476]\n"
      "    twist: {frame: world, linear: [1, 0, 0], angular: [0, 0, 4]}\n");
  const World world = buildWorld(scene);
  const BodyState state = initialState(scene, world).bodies[0];
  // a handful of roundings of numbers below 4
  EXPECT_LE((state.x_W - Vector3d(1, 2.5, 3)).norm(), 4e-15);
  EXPECT_LE((state.p_W - 2 * Vector3d(1 - 4 * 0.5, 0, 0)).norm(), 4e-15);
  EXPECT_LE((state.L_W - Vector3d(0, 0, 4)).norm(), 4e-15);
}

TEST(InitialState, ReadsATwistInTheAxesItNames) {
  const std::string turned =
      "    shape: {box: [0.1, 0.4, 0.9]}\n    mass: 10\n"
      "    orientation: [0, 0, 0.7071067811865476, 0.7071067811865476]\n";
  const auto motion = [](const Scene& scene) {
    const World world = buildWorld(scene);
    return toBodyFrameMotion(world.bodies[0], initialState(scene, world).bodies[0]);
  };
  const BodyFrameMotion in_body =
      motion(sceneOf(turned + "    twist: {frame: body, linear: [1, 0, 2], angular: [3, 4, 0]}\n"));
  const BodyFrameMotion in_world = motion(
      sceneOf(turned + "    twist: {frame: world, linear: [0, 1, 2], angular: [-4, 3, 0]}\n"));
  EXPECT_LE((in_body.v_W - Vector3d(0, 1, 2)).norm(), 4e-15);
  EXPECT_LE((in_world.v_W - Vector3d(0, 1, 2)).norm(), 4e-15);
  EXPECT_LE((in_body.w_W - Vector3d(-4, 3, 0)).norm(), 8e-15);
  EXPECT_LE((in_world.w_W - Vector3d(-4, 3, 0)).norm(), 8e-15);
}

TEST(InitialState, RestsAtTheOriginUnlessStatedOtherwise) {
  const Scene scene = sceneOf("    shape: {box: [0.1, 0.4, 0.9]}\n    mass: 10\n");
  const World world = buildWorld(scene);
  const State state = initialState(scene, world);
  EXPECT_EQ(state.t, 0);
  EXPECT_EQ(state.bodies[0].x_W, Vector3d::Zero());
  EXPECT_EQ(state.bodies[0].p_W, Vector3d::Zero());
  EXPECT_EQ(state.bodies[0].L_W, Vector3d::Zero());
  const BodyFrameMotion motion = toBodyFrameMotion(world.bodies[0], state.bodies[0]);
  EXPECT_LE(angleBetween(motion.q_WB, Quaterniond::Identity()), 1e-15);
}

TEST(BuildWorld, KeepsAFixedBodyFixed) {
  const World world =
      buildWorld(sceneOf("    shape: {box: [1, 1, 1]}\n    mass: 1\n    fixed: true\n"));
  EXPECT_TRUE(world.bodies[0].fixed);
}

// As in AppliedWrench.msg.
TEST(BuildWorld, TakesAnEmptyPointFrameAsTheBody) {
  const Scene scene = parseScene(
      "time_step: 0.01\n"
      "bodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n"
      "wrenches: [{body: a, frame: world, point_frame: '', point: [1, 2, 3], duration: 1}]\n",
      "s");
  const PointWrench wrench = buildWorld(scene).wrenches[0];
  EXPECT_EQ(wrench.point_frame, 0u);
  EXPECT_EQ(wrench.point, Vector3d(1, 2, 3));
}

TEST(BuildWorld, RefusesAMotionWhoseMomentaAreNotFinite) {
  const Scene scene = sceneOf(
      "    shape: {box: [1, 2, 3]}\n    mass: 1\n"
      "    twist: {frame: body, angular: [1e308, 1e308, 1e308]}\n");
  try {
    initialState(scene, buildWorld(scene));
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "test.yaml:3: body 'box': its position and momenta must be finite");
  }
}

TEST(BuildWorld, HoldsAWrenchOfInfiniteDurationForEver) {
  const Scene scene = parseScene(
      "time_step: 0.01\n"
      "bodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n"
      "wrenches: [{body: a, frame: world, force: [1, 0, 0], start: 2, duration: .inf}]\n",
      "s");
  const PointWrench wrench = buildWorld(scene).wrenches[0];
  EXPECT_EQ(wrench.start, 2);
  EXPECT_EQ(wrench.end, std::numeric_limits<double>::infinity());
}

}  // namespace rigid_body_sim
