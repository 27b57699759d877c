#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using test::Outcome;

/// Runs `simulate` with the arguments, one string as a shell takes it.
Outcome simulate(const std::string& arguments) {
  return test::runCommand(std::string(RIGID_BODY_SIM_SIMULATE) + " " + arguments);
}

std::string scenePath(const std::string& name) {
  return std::string(RIGID_BODY_SIM_SCENES) + "/" + name;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

/// The numbers of a row; the body's name reads as zero.
std::vector<double> numbers(const std::string& row) {
  std::vector<double> all;
  std::istringstream stream(row);
  for (std::string field; std::getline(stream, field, ',');)
    all.push_back(std::strtod(field.c_str(), nullptr));
  return all;
}

}  // namespace

TEST(Simulate, WritesARowForEachBodyAndSampleUpToTheEnd) {
  const Outcome run =
      simulate(scenePath("free_space.yaml") + " --csv - --duration 0.25 --sample 0.1 2>/dev/null");
  EXPECT_EQ(run.exit_code, 0);
  const std::vector<std::string> rows = lines(run.out);
  ASSERT_EQ(rows.size(), 1U + 2 * 4);
  EXPECT_EQ(rows[0], "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
  const std::vector<double> times{0, 0.1, 0.2, 0.25};
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_DOUBLE_EQ(numbers(rows[1 + 2 * k])[0], times[k]);
    EXPECT_NE(rows[1 + 2 * k].find(",box,"), std::string::npos);
    EXPECT_NE(rows[2 + 2 * k].find(",wing_nut,"), std::string::npos);
  }
}

TEST(Simulate, WritesTheEndHoweverItLiesToTheSamples) {
  const auto times = [](const std::string& options) {
    const Outcome run =
        simulate(scenePath("wing_nut.yaml") + " --csv - " + options + " 2>/dev/null");
    std::vector<double> all;
    for (const std::string& row : lines(run.out))
      if (row.find("time") != 0) all.push_back(numbers(row)[0]);
    return all;
  };
  EXPECT_EQ(times("--duration 1e-9 --sample 1"), (std::vector<double>{0, 1e-9}));
  EXPECT_EQ(times("--duration 1.0000001 --sample 0.5"),
            (std::vector<double>{0, 0.5, 1, 1.0000001}));
  EXPECT_EQ(times("--duration 2e-7 --sample 1e-7 --time-step 1"),
            (std::vector<double>{0, 1e-7, 2e-7}));
}

TEST(Simulate, WritesTheVeryNumbersOfTheCore) {
  const Outcome run = simulate(scenePath("thrown_box.yaml") + " --csv - --duration 1 2>/dev/null");
  const Scene scene = loadScene(scenePath("thrown_box.yaml"));
  const World world = buildWorld(scene);
  Simulation simulation(world, initialState(scene, world));
  while (simulation.steps() < 100) simulation.step();
  const BodyFrameMotion m = toBodyFrameMotion(world.bodies[0], simulation.body(0));

  const std::vector<std::string> rows = lines(run.out);
  ASSERT_EQ(rows.size(), 102U);
  const std::vector<double> expected{1,          0,          m.x_W.x(),  m.x_W.y(),  m.x_W.z(),
                                     m.q_WB.x(), m.q_WB.y(), m.q_WB.z(), m.q_WB.w(), m.v_W.x(),
                                     m.v_W.y(),  m.v_W.z(),  m.w_W.x(),  m.w_W.y(),  m.w_W.z()};
  EXPECT_EQ(numbers(rows.back()), expected);
}

TEST(Simulate, RunsForTheHorizonOfTheScene) {
  EXPECT_NE(simulate(scenePath("thrown_box.yaml")).out.find(": 4 s in steps of 0.01 s"),
            std::string::npos);
}

TEST(Simulate, TakesMethodAndStepFromTheCommandLine) {
  EXPECT_NE(
      simulate(scenePath("free_space.yaml") + " --integrator rk4 --time-step 0.02 --duration 1")
          .out.find(": 1 s in steps of 0.02 s with rk4"),
      std::string::npos);
}

TEST(Simulate, SaysHowEachBodyIsSolved) {
  const Outcome run = simulate(scenePath("free_space.yaml") + " --duration 0.1 2>&1 >/dev/null");
  EXPECT_EQ(lines(run.out), (std::vector<std::string>{"box: free, asymmetric, exact",
                                                      "wing_nut: free, asymmetric, exact"}));
}

TEST(Simulate, SaysOfVeryManyBodiesHowManyThereAre) {
  std::string bodies = "time_step: 0.01\nbodies:\n";
  for (int i = 0; i < 102; ++i)
    bodies += "  - {name: b" + std::to_string(i) + ", shape: {sphere: {radius: 1}}, mass: 1}\n";
  const std::vector<std::string> said =
      lines(simulate(sceneFile(bodies) + " --duration 0.1 2>/dev/null").out);
  ASSERT_EQ(said.size(), 202U);
  EXPECT_EQ(said.back(), "and 2 more bodies, which --csv or --bag writes");
}

TEST(Simulate, SaysWhatChangedABodyOrThatNothingDid) {
  const std::string bodies = R"(
time_step: 0.01
gravity: [0, 0, -10]
bodies:
  - {name: free, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: pushed, shape: {sphere: {radius: 1}}, mass: 1, position: [9, 0, 0]}
  - {name: held, shape: {sphere: {radius: 1}}, mass: 1, position: [0, 9, 0]}
wrenches: [{body: pushed, frame: world, force: [2, 0, 10], duration: 1}]
forces: [{type: spring, from: {body: held}, to: {world: [0, 9, 1]}, stiffness: 4}]
)";
  const std::vector<std::string> said =
      lines(simulate(sceneFile(bodies) + " --duration 1 2>/dev/null").out);
  ASSERT_EQ(said.size(), 8U);
  EXPECT_EQ(said[2].find("  conserved: energy "), 0U) << said[2];
  EXPECT_NE(said[2].find(", angular momentum to 0"), std::string::npos) << said[2];
  // 2 N for 1 s on 1 kg, and its weight of 10 N
  EXPECT_EQ(said[4],
            "  changed by wrenches: energy +2 J, momentum (2, 0, 10) N s, angular momentum "
            "(0, 0, 0) N m s");
  EXPECT_EQ(said[6].find("  changed by spring: energy "), 0U) << said[6];
}

TEST(Simulate, PrintsNoNumberThatIsTooGreatForOne) {
  const auto saidOf = [](const std::string& mass_and_twist) {
    return lines(simulate(sceneFile("time_step: 0.01\ngravity: [0, 0, -10]\nbodies:\n"
                                    "  - {name: ball, shape: {sphere: {radius: 1.0e-3}}, " +
                                    mass_and_twist +
                                    "}\nwrenches: [{body: ball, frame: world, force: [1, 0, 0], "
                                    "start: 5, duration: 1}]\n") +
                          " --duration 1 2>/dev/null")
                     .out);
  };
  // the square of the momentum would be infinite, the energy is not
  const std::vector<std::string> heavy = saidOf("mass: 1.0e300");
  ASSERT_EQ(heavy.size(), 3U);
  EXPECT_EQ(heavy[2], "  conserved: energy 0 J to 0, momentum to 0, angular momentum to 0");
  const std::vector<std::string> far = saidOf("mass: 1.0e300, position: [0, 0, 1.0e9]");
  ASSERT_EQ(far.size(), 3U);
  EXPECT_EQ(far[2],
            "  whether conserved is not known: energy and momenta are too great for numbers");
}

TEST(Simulate, RefusesAnIntegratorThatDoesNotTakeTheScene) {
  const Outcome run = simulate(scenePath("spring_pair.yaml") + " --integrator taylor 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines(run.out).size(), 1U);
  EXPECT_NE(run.out.find("spring_pair.yaml: integrator must be auto or support"), std::string::npos)
      << run.out;
}

TEST(Simulate, ExitsWithOneForBadInput) {
  const Outcome absent = simulate("absent.yaml 2>&1");
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_EQ(lines(absent.out).size(), 1U);
  EXPECT_NE(absent.out.find("absent.yaml"), std::string::npos);
  EXPECT_EQ(simulate(sceneFile("time_step: -1\nbodies: []\n") + " 2>&1").exit_code, 1);
  EXPECT_EQ(simulate(scenePath("free_space.yaml") + " --csv /dev/full 2>&1").exit_code, 1);
}

TEST(Simulate, SaysWhatIsAtFaultAndNothingElse) {
  // a mesh that faces inwards, told of when all is well
  const TemporaryDirectory files;
  const std::string mesh =
      files.written("inwards.stl", binaryStl(insideOut(triangulated(Box{{1, 1, 1}}, 0))));
  const std::string body = "bodies: [{name: a, mass: 1, shape: {mesh: {file: " + mesh + "}}}]\n";
  const std::string good = sceneFile("time_step: 0.1\n" + body);
  const std::string notice = simulate(good + " 2>&1 >/dev/null").out;
  EXPECT_EQ(lines(notice).size(), 2U) << notice;
  EXPECT_NE(notice.find("simulate: notice: "), std::string::npos) << notice;
  for (const char* output : {" --csv /dev/full", " --bag /dev/full"}) {
    const Outcome run = simulate(good + output + " 2>&1");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(lines(run.out).size(), 1U) << run.out;
  }
  EXPECT_EQ(simulate(good + " 2>/dev/null >/dev/full").exit_code, 1);
  const std::string bad =
      sceneFile("time_step: 0.1\n" + body + "wrenches: [{body: b, frame: world, duration: 1}]\n");
  const Outcome run = simulate(bad + " 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(lines(run.out).size(), 1U) << run.out;
}

TEST(Simulate, ExitsWithTwoForWrongUsage) {
  const std::string free_space = scenePath("free_space.yaml");
  for (const std::string& arguments :
       {std::string(""), std::string("a.yaml b.yaml"), std::string("a.yaml --no-such-option"),
        std::string("a.yaml --duration"), std::string("a.yaml --duration 1x"),
        std::string("a.yaml --duration 0x10"), std::string("a.yaml -xyz"),
        std::string("a.yaml --sample 0"), std::string("a.yaml --time-step nan"),
        free_space + " --integrator bogus", free_space + " --integrator rk4 --tolerance 1e-6",
        free_space + " --duration 1e300", free_space + " --duration 1e18",
        free_space + " --sample 1e-30",
        free_space + " --integrator rk4 --time-step 1e-20 --duration 1"}) {
    const Outcome run = simulate(arguments + " 2>&1");
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(lines(run.out).size(), 1U) << arguments;
  }
  EXPECT_EQ(simulate(free_space + " --duration 1e300 2>&1").out,
            "simulate: a duration of 1e+300 s must be at most 2^53 steps of 0.001 s "
            "(simulate --help)\n");
}

TEST(Simulate, TakesShortOptionsOnlyWhereTheyAreShortForOne) {
  const std::string scene = scenePath("free_space.yaml");
  EXPECT_EQ(simulate(scene + " --dur 0.01 2>&1").exit_code, 0);
  EXPECT_EQ(simulate(scene + " --t 3 2>&1").out,
            "simulate: option --t is short for several, --threads, --time-step, --tolerance: write "
            "one in full (simulate --help)\n");
  EXPECT_EQ(simulate(scene + " --help=3 2>&1").out,
            "simulate: --help takes no value (simulate --help)\n");
  EXPECT_EQ(simulate(scene + " --duration=1 -xyz 2>&1").out,
            "simulate: unknown option -x (simulate --help)\n");
}

TEST(Simulate, TakesEachOptionOnceAndNothingEmpty) {
  const std::string scene = scenePath("free_space.yaml");
  EXPECT_EQ(simulate(scene + " --duration 1 --dur 2 2>&1").out,
            "simulate: --duration is given twice (simulate --help)\n");
  EXPECT_EQ(simulate(scene + " --csv '' 2>&1").out,
            "simulate: --csv: must not be empty (simulate --help)\n");
  EXPECT_EQ(simulate("'' 2>&1").out,
            "simulate: an argument is empty: it must be a path (simulate --help)\n");
}

TEST(Simulate, ExitsWithThreeWhenTheSimulationDiverges) {
  const std::string scene = sceneFile(R"(
time_step: 1.0
bodies: [{name: rocket, shape: {sphere: {radius: 1}}, mass: 1.0e-300}]
wrenches: [{body: rocket, frame: world, force: [1.0e+300, 0, 0], duration: 1000}]
)");
  const Outcome run = simulate(scene + " 2>&1");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(lines(run.out).size(), 2U);  // how it is solved, and what went wrong
  EXPECT_NE(run.out.find("body 'rocket'"), std::string::npos) << run.out;
  const Outcome between = simulate(scene + " --sample 0.3 --csv - 2>&1");
  EXPECT_EQ(between.exit_code, 3);
  EXPECT_EQ(between.out.find("nan"), std::string::npos) << between.out;
  EXPECT_NE(between.out.find("body 'rocket'"), std::string::npos) << between.out;
}

TEST(Simulate, HelpsOnRequest) {
  const Outcome run = simulate("--help");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("usage: simulate SCENE"), std::string::npos);
}

}  // namespace rigid_body_sim
