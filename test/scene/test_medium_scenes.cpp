#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene_texts.hpp"

/// Medium, drag and buoyancy in scenes.
namespace rigid_body_sim {
namespace {

/// A box of 8 litres; its keys begin on line 6.
std::string inMedium(const std::string& keys, const std::string& top = "medium: {density: 1000}\n",
                     const std::string& gravity = "gravity: [0, 0, -10]\n") {
  return gravity + top + "time_step: 0.01\nbodies:\n  - name: box\n    " + keys + "\n";
}

const std::string kBoxOfWater = "shape: {box: [0.2, 0.2, 0.2]}\n    mass: 8\n    ";

Simulation simulationOf(const std::string& text) {
  const Scene scene = parseScene(text, "s.yaml");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

Simulation shippedSimulation(const std::string& name) {
  const Scene scene = loadScene(std::string(RIGID_BODY_SIM_SCENES) + "/" + name);
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

Simulation runShipped(const std::string& name) {
  Simulation sim = shippedSimulation(name);
  while (sim.time() < sim.world().solver.horizon - 1e-9) sim.step();
  return sim;
}

const MediumDrag& dragOf(const Simulation& sim) {
  return dynamic_cast<const MediumDrag&>(*sim.world().laws[0]);
}

}  // namespace

TEST(SceneMedium, HasRulesForItsKeys) {
  const auto error = [](const std::string& medium) {
    return errorOf(inMedium(kBoxOfWater, "medium: " + medium + "\n"));
  };
  EXPECT_EQ(error("{density: -1}"), "s.yaml:2: medium.density must be >= 0 kg/m^3, got -1");
  EXPECT_EQ(error("{velocity: [1, 0]}"),
            "s.yaml:2: medium.velocity must be a list of 3 numbers [m/s], got [1, 0]");
  EXPECT_EQ(error("{speed: 1}"), "s.yaml:2: unknown key 'medium.speed' (known: density, velocity)");
}

TEST(SceneDrag, TakesThreeNumbersAndACentre) {
  const Simulation sim = simulationOf(
      inMedium(kBoxOfWater + "drag: {linear: 2, quadratic: [1, 2, 3], center: [0.1, 0, 0]}"));
  const MediumDrag::Coefficients& drag = dragOf(sim).coefficients();
  EXPECT_EQ(drag.linear.alike, 2);
  EXPECT_EQ(drag.quadratic.axes, Vector3d(1, 2, 3));
  EXPECT_EQ(drag.quadratic.alike, 0);
  EXPECT_NEAR(drag.center_P.norm(), 0.1, 1e-15);
  EXPECT_EQ(describeSolution(sim)[0], "box: gravity, drag, Taylor");
}

TEST(SceneDrag, HasRulesForThreeNumbers) {
  const auto error = [](const std::string& drag) {
    return errorOf(inMedium(kBoxOfWater + "drag: " + drag));
  };
  const std::string at = "s.yaml:8: body 'box': ";
  EXPECT_EQ(error("{linear: [1, 2]}"),
            at + "drag.linear must be a number or a list of 3 numbers [N s/m], got [1, 2]");
  EXPECT_EQ(error("{angular: [1, 2, -3]}"), at + "drag.angular[2] must be >= 0 N m s, got -3");
  EXPECT_EQ(error("{center: 1}"), at + "drag.center must be a list of 3 numbers [m], got 1");
}

TEST(SceneMedium, ActsOnNoFixedBody) {
  const std::string rule = " cannot move the body, which is fixed; remove one of the two";
  const std::string fixed = kBoxOfWater + "fixed: true\n    ";
  EXPECT_EQ(errorOf(inMedium(fixed + "buoyancy: true")), "s.yaml:9: body 'box': buoyancy" + rule);
  EXPECT_EQ(errorOf(inMedium("shape: {plane: {}}\n    fixed: true\n    buoyancy: {volume: 1}")),
            "s.yaml:8: body 'box': buoyancy" + rule);
  EXPECT_EQ(errorOf(inMedium(fixed + "drag: {linear: 1}")), "s.yaml:5: body 'box': drag" + rule);
  EXPECT_EQ(errorOf(inMedium(fixed + "buoyancy: false\n    drag: {linear: 0}")), "");
}

// Neutral in water: it stays where it is.
TEST(SceneBuoyancy, HoldsABodyAsDenseAsTheMedium) {
  Simulation sim = simulationOf(inMedium(kBoxOfWater + "buoyancy: true"));
  while (sim.steps() < 100) sim.step();
  EXPECT_LE(sim.body(0).x_W.norm(), 1e-14);
  EXPECT_EQ(describeSolution(sim)[0], "box: gravity, buoyancy, Taylor");
}

// Two cubes of different mass: the centroid of volume lies between them, whatever they weigh.
TEST(SceneBuoyancy, ActsAtTheCentroidOfVolumeOfParts) {
  const Simulation sim = simulationOf(inMedium(
      "parts: [{shape: {box: [1, 1, 1]}, mass: 1, position: [1, 0, 0]}, {shape: {box: [1, 1, 1]}, "
      "mass: 3, position: [-1, 0, 0]}]\n    buoyancy: true"));
  const State state = sim.state();
  std::vector<Wrench> wrenches(1);
  sim.world().laws[0]->addWrenches({{&sim.world().bodies[0]}, state.bodies}, wrenches);
  EXPECT_NEAR(wrenches[0].f_W.z(), 20000, 1e-9);
  // half a metre from the centre of mass, along x: τ_y = −x F
  EXPECT_NEAR(rotate(state.bodies[0].q_WP, wrenches[0].tau_P).y(), -0.5 * 20000, 1e-9);
}

TEST(SceneBuoyancy, TakesAVolumeAndACentre) {
  Simulation sim = simulationOf(
      inMedium("mass: 8\n    inertia: {ixx: 1, iyy: 1, izz: 1}\n    buoyancy: {volume: 0.004}"));
  while (sim.steps() < 100) sim.step();
  EXPECT_NEAR(sim.body(0).x_W.z(), -2.5, 1e-12);  // half of its weight is left
}

TEST(SceneBuoyancy, NeedsVolumeDensityAndUniformGravity) {
  const std::string at = "s.yaml:8: body 'box': buoyancy ", on = kBoxOfWater + "buoyancy: true";
  const std::string density = "needs the density of the medium: add medium: {density: ..} [kg/m^3]";
  EXPECT_EQ(errorOf(inMedium(on, "medium: {}\n")), at + density);
  EXPECT_EQ(errorOf(inMedium(on, "world_frame: map\n")), at + density);
  EXPECT_EQ(errorOf(inMedium(on, "medium: {density: 1}\n", "gravity: [0, 0, 0]\n")),
            at + "needs gravity, which is uniform: add gravity: [0, 0, -9.80665]");
  EXPECT_EQ(errorOf(inMedium(on + "\nforces: [{type: central_gravity, mu: 1}]")),
            at + "cannot stand beside central_gravity, for its law is that of uniform gravity");
  EXPECT_EQ(errorOf(inMedium("mass: 8\n    inertia: {ixx: 1, iyy: 1, izz: 1}\n    buoyancy: true")),
            at +
                "must be {volume: .., center: [x, y, z]} here, for what the body is made of has no "
                "volume that the scene tells, got true");
  EXPECT_EQ(errorOf(inMedium(kBoxOfWater + "buoyancy: {center: [0, 0, 0]}")),
            "s.yaml:8: body 'box': missing key 'buoyancy.volume'");
  EXPECT_EQ(errorOf(inMedium(kBoxOfWater + "buoyancy: {volume: -1}")),
            "s.yaml:8: body 'box': buoyancy.volume must be > 0 m^3, got -1");
  EXPECT_EQ(errorOf(inMedium(kBoxOfWater + "buoyancy: {volume: 1.0e+307}")),
            "s.yaml:5: body 'box': law 'buoyancy': the mass displaced must be >= 0 kg and finite, "
            "got inf");
  EXPECT_EQ(
      errorOf(inMedium(kBoxOfWater + "buoyancy: 3")),
      "s.yaml:8: body 'box': buoyancy must be true, false or {volume: .., center: [x, y, z]}, "
      "got 3");
}

TEST(SceneMedium, IsRefusedByIntegratorsThatDoNotSupportIt) {
  EXPECT_EQ(errorOf(inMedium(kBoxOfWater + "drag: {linear: [1, 2, 3]}\nintegrator: strang")),
            "s.yaml:9: integrator must be auto or support damping, as body 'box' needs "
            "(semi_implicit_euler, rk4, dop853), got 'strang'");
}

// Sims 01 and 04 of the check case agree to 1e-10 deg/s.
TEST(NasaTumblingBrick, HasThePublishedRates) {
  const Simulation sim = runShipped("nasa_tumbling_brick.yaml");
  const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  const Vector3d rates = rotateBack(m.q_WB, m.w_W) * 180 / M_PI;
  EXPECT_NEAR(rates.x(), 12.6183907757, 1e-9);
  EXPECT_NEAR(rates.y(), -17.3974747619, 1e-9);
  EXPECT_NEAR(rates.z(), 31.1195888868, 1e-9);
}

/// What a sim publishes: yaw, pitch and roll against north, east and down at its longitude [deg].
struct PublishedAttitude {
  double t, longitude, yaw, pitch, roll;
};

/// Over the equator, the Earth having turned at its rate in WGS 84.
Quaterniond inertialAttitude(const PublishedAttitude& at) {
  constexpr double deg = M_PI / 180;
  const auto about = [](double angle, const Vector3d& axis) {
    return Quaterniond(Eigen::AngleAxisd(angle, axis));
  };
  // x to the north, z down, where the longitude and the Earth's angle are zero
  const Quaterniond level = about(-M_PI / 2, Vector3d::UnitY());
  return about(7.292115e-5 * at.t + at.longitude * deg, Vector3d::UnitZ()) * level *
         about(at.yaw * deg, Vector3d::UnitZ()) * about(at.pitch * deg, Vector3d::UnitY()) *
         about(at.roll * deg, Vector3d::UnitX());
}

// Sims 01 and 04 of the check case, which differ by 5e-11 rad themselves.
TEST(NasaTumblingBrick, HasThePublishedAttitude) {
  const std::vector<PublishedAttitude> published{
      {10, 2.12654136235e-6, -4.321336367926564, 3.7413374738658383, -66.01900324375518},
      {10, 2.12654133805e-6, -4.32133636889, 3.74133747365, -66.0190032425},
      {20, 1.70166179171e-5, -6.3696938240052745, 4.059829768024102, 4.1383179964505},
      {20, 1.70166180963e-5, -6.36969382585, 4.05982976745, 4.13831799799},
      {30, 5.74552194388e-5, -4.289355039311268, -3.81965492049295, -56.151307596646866},
      {30, 5.74552213287e-5, -4.28935504226, -3.81965492189, -56.1513075938}};
  Simulation sim = shippedSimulation("nasa_tumbling_brick.yaml");
  for (const PublishedAttitude& at : published) {
    while (sim.time() < at.t - 1e-9) sim.step();
    const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
    EXPECT_LT(angleBetween(m.q_WB, inertialAttitude(at)), 1e-10) << at.t;
  }
}

// NESC check cases 06 and 07, to 5 s: by then the air is denser by 1.4 %, and gravity greater.
TEST(NasaDroppedSphere, FallsAndDriftsAsPublished) {
  constexpr double ft = 0.3048;
  std::vector<BodyState> ends;
  for (const std::string wind : {"[0, 0, 0]", "[6.096, 0, 0]"}) {
    Simulation sim = simulationOf(
        "gravity: [0, 0, -9.75210648]\nmedium: {velocity: " + wind +
        "}\ntime_step: 0.1\nbodies: [{name: sphere, shape: {sphere: {radius: 0.0762}}, mass: "
        "14.593902937, drag: {quadratic: 4.186784939e-4}}]\n");
    while (sim.steps() < 50) sim.step();
    ends.push_back(sim.body(0));
  }
  EXPECT_NEAR(ends[0].x_W.z() / ft, 29600.5264071 - 30000, 5e-4);
  EXPECT_NEAR(ends[1].x_W.z() / ft, 29600.5451978 - 30000, 5e-4);
  const double drift = (ends[1].p_W.x() - ends[0].p_W.x()) / 14.593902937 / ft;
  EXPECT_NEAR(drift, 0.131972905713 - 0.058158194762, 6e-4);
}

TEST(ThrownDartScene, TurnsIntoTheWindThatItMakes) {
  const Simulation sim = runShipped("thrown_dart.yaml");
  EXPECT_TRUE(sim.plans()[0].integrator.empty());
  const BodyFrameMotion m = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
  const Vector3d through = m.v_W - Vector3d(0, 1, 0);
  EXPECT_GT(rotate(m.q_WB, Vector3d(Vector3d::UnitX())).dot(through.normalized()), 0.9);
}

TEST(BalloonScene, DriftsWithTheWindAndRises) {
  const Simulation sim = runShipped("balloon.yaml");
  EXPECT_TRUE(sim.plans()[0].integrator.empty());
  const Vector3d v = sim.body(0).p_W / sim.world().bodies[0].mass;
  EXPECT_NEAR(v.x(), 3, 0.05);
  EXPECT_NEAR(v.y(), 1, 0.05);
  EXPECT_GT(v.z(), 0.5);
}

TEST(BuoyScene, SettlesDownstreamOfItsMooring) {
  const Simulation sim = runShipped("buoy.yaml");
  EXPECT_LT(sim.body(0).p_W.norm() / sim.world().bodies[0].mass, 0.05);
  EXPECT_GT(sim.body(0).x_W.x(), 0.2);
  EXPECT_EQ(sim.state().laws.back(), 1);  // taut
}

TEST(SlungLoadScene, CarriesTheCrate) {
  const Simulation sim = runShipped("slung_load.yaml");
  EXPECT_LT((sim.body(0).x_W - sim.body(1).x_W).norm(), 1.8);
  EXPECT_GT(sim.body(1).x_W.z(), -20);
}

TEST(TowedBodyScene, DrawsTheSondeBehindTheLaunch) {
  const Simulation sim = runShipped("towed_body.yaml");
  EXPECT_GT(sim.body(1).p_W.x(), 0.5 * sim.world().bodies[1].mass);
  EXPECT_GT(sim.body(0).x_W.x() - sim.body(1).x_W.x(), 2);
}

}  // namespace rigid_body_sim
