#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/study/study.hpp"

namespace rigid_body_sim {
namespace {

std::string studyFault(const std::string& text) {
  try {
    parseStudy(text, "study.yaml");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Study, IsReadAsItIsWritten) {
  const Study study = parseStudy(R"(
runs: 20
seed: 7
duration: 2.5
vary:
  bodies.box.mass: {normal: {mean: 2.0, stddev: 0.05}}
  bodies.box.twist.angular[2]: {uniform: [1, 3]}
  bodies.box.orientation: {rotation: {}}
  integrator: {grid: [auto, rk4]}
  bodies.box.position: {list: [[0, 0, 1], [0, 0, 2]]}
record:
  apex: {max: box.pz}
  hits_ground: {first: {box.pz: {below: 0}}}
  final_spin: {at_end: box.w}
)",
                                 "study.yaml");
  EXPECT_EQ(study.runs, 20);
  EXPECT_EQ(study.seed, 7U);
  EXPECT_EQ(study.duration, 2.5);
  ASSERT_EQ(study.vary.size(), 5U);
  EXPECT_EQ(std::get<NormalDistribution>(study.vary[0].distribution).stddev, 0.05);
  EXPECT_EQ(std::get<UniformDistribution>(study.vary[1].distribution).high, 3);
  EXPECT_FALSE(std::get<RotationDistribution>(study.vary[2].distribution).stddev);
  EXPECT_EQ(std::get<GridDistribution>(study.vary[3].distribution).values[1].words[0].text, "rk4");
  EXPECT_EQ(std::get<ListDistribution>(study.vary[4].distribution).values[1].words[2].text, "2");
  ASSERT_EQ(study.record.size(), 3U);
  EXPECT_EQ(study.record[0].quantity.name, "pz");
  EXPECT_EQ(study.record[1].reduction, Reduction::kFirst);
  EXPECT_TRUE(study.record[1].below);
  EXPECT_EQ(study.record[2].quantity.body, "box");
  EXPECT_EQ(gridSize(study), 2);
}

TEST(Study, NamesWhatIsAtFault) {
  const std::string mass = "runs: 1\nvary: {bodies.box.mass: ";
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"vary: {a: {list: [1]}}", "study.yaml:1: missing key 'runs'"},
      {"runs: 5", "study.yaml:1: missing key 'vary'"},
      {"runs: -5\nvary: {a: {list: [1]}}",
       "study.yaml:1: runs must be a whole number from 1 to 100000000, got -5"},
      {"runs: 2.5\nvary: {a: {list: [1]}}",
       "study.yaml:1: runs must be a whole number from 1 to 100000000, got 2.5"},
      {"runs: 1\nseed: -1\nvary: {a: {list: [1]}}",
       "study.yaml:2: seed must be a whole number from 0 to 2^64 - 1, got -1"},
      {"runs: 1\nruns: 2", "study.yaml:2: key 'runs' is repeated"},
      {"runs: 1\nduration: 1e-320\nvary: {a: {list: [1]}}",
       "study.yaml:2: duration must be at least 1e-300 s, got 1e-320"},
      {"# nothing\n", "study.yaml: is empty; it must be a YAML mapping"},
      {"runs: 1\nvary: {}",
       "study.yaml:2: vary must be a mapping of at least one path to what its value may be, got a "
       "mapping"},
      {mass + "{list: []}}",
       "study.yaml:2: vary.bodies.box.mass.list must be a list of at least one value, got []"},
      {mass + "{normal: {mean: heavy, stddev: 1}}}",
       "study.yaml:2: vary.bodies.box.mass.normal.mean must be a number, got heavy"},
      {mass + "{normal: {mean: 1, stddev: 0}}}",
       "study.yaml:2: vary.bodies.box.mass.normal.stddev must be > 0, got 0"},
      {mass + "{uniform: [3, 1]}}",
       "study.yaml:2: vary.bodies.box.mass.uniform must be [low, high] with low < high, got [3, "
       "1]"},
      {mass + "{gaussian: 1}}",
       "study.yaml:2: unknown key 'vary.bodies.box.mass.gaussian' (known: normal, uniform, list, "
       "grid, rotation)"},
      {mass + "{list: [1], grid: [2]}}",
       "study.yaml:2: vary.bodies.box.mass must name exactly one distribution, got list and grid"},
      {"gravity: [0, 0, 0]\nbodies: []",
       "study.yaml:1: is a scene, not a study: the scene comes first, the study second"},
      {mass + "{list: [1, [2, 3]]}}",
       "study.yaml:2: vary.bodies.box.mass.list[1] must have as many numbers as the values before "
       "it, got [2, 3]"},
      {"runs: 1\nvary: {a: {list: [1]}}\nrecord: {apex: {max: pz}}",
       "study.yaml:3: record.apex.max must be a body and a quantity, such as box.pz, got pz"},
      {"runs: 1\nvary: {a: {list: [1]}}\nrecord: {apex: {max: box.height}}",
       "study.yaml:3: record.apex.max: unknown quantity 'height' (known: px, py, pz, qx, qy, qz, "
       "qw, vx, vy, vz, wx, wy, wz, v, w)"},
      {"runs: 1\nvary: {a: {list: [1]}}\nrecord: {down: {first: {box.pz: 0}}}",
       "study.yaml:3: record.down.first.box.pz must be a mapping, got 0 (keys: below, above)"},
      {"runs: 1\nvary: {a: {list: [1]}}\nrecord: {status: {max: box.pz}}",
       "study.yaml:3: record: 'status' is a column that every sweep has"},
  };
  for (const auto& [text, message] : faults) EXPECT_EQ(studyFault(text), message) << text;
}

TEST(Study, RefusesGridsOfMoreRunsThanCanBe) {
  std::string text = "runs: 1000\nvary:\n";
  for (const char* path : {"a", "b", "c"}) {
    text += std::string("  ") + path + ": {grid: [0";
    for (int i = 1; i < 100; ++i) text += ", " + std::to_string(i);
    text += "]}\n";
  }
  EXPECT_EQ(studyFault(text),
            "study.yaml:2: runs times the values of the grids must be at most 100000000, got 1000 "
            "times 1000000");
}

}  // namespace rigid_body_sim
