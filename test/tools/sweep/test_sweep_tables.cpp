#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/sweep_info.hpp"

/// Tables that somebody has changed.
namespace rigid_body_sim {

// As many rows as there should be, one of them that of another run.
TEST(SweepProgram, GoesOnWithNoTableThatSomebodyHasChanged) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 6\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string out = files.path("out");
  const std::string command = scene + " " + study + " --out " + out;
  const std::string no_plot = "PATH=/nonexistent";
  ASSERT_EQ(test::sweep(command, no_plot).exit_code, 0);
  for (const char* name : {"runs", "fan"}) {
    const std::string table = out + "/" + name + ".csv", rows = test::fileText(table);
    const std::size_t second = rows.find("\n1,") + 1, third = rows.find("\n2,") + 1;
    // the row of run 1 is gone, and run 2 there twice
    const std::string changed = rows.substr(0, second) +
                                rows.substr(third, rows.find("\n3,") + 1 - third) +
                                rows.substr(third);
    files.written("out/" + std::string(name) + ".csv", changed);
    for (const std::string& arguments : {command + " --resume", "merge " + out}) {
      const test::Outcome run = test::sweep(arguments);
      EXPECT_EQ(run.exit_code, 1);
      EXPECT_EQ(run.out.find("sweep: " + table + ":3: must be the row of run 1, got '2,"), 0U)
          << run.out;
      EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
      EXPECT_EQ(test::fileText(table), changed);
      EXPECT_FALSE(std::ifstream(table + ".part").good());
    }
    ASSERT_EQ(test::sweep(command, no_plot).exit_code, 0);
  }
  // as a program leaves it that writes the ends of lines in its own way
  std::string rows = test::fileText(out + "/runs.csv");
  const std::string done = ",done\n";
  rows.replace(rows.find(done), done.size(), ",done\r\n");
  files.written("out/runs.csv", rows);
  EXPECT_EQ(
      test::sweep("merge " + out).out.find("sweep: " + out + "/runs.csv:2: status must be done, "),
      0U);
  ASSERT_EQ(remove((out + "/runs.info").c_str()), 0);
  EXPECT_EQ(test::sweep(command + " --resume").out,
            "sweep: " + out +
                "/runs.info: is not there; only by it is known of which sweep the rows of "
                "runs.csv are: put it back, or remove runs.csv to begin anew\n");
}

TEST(SweepProgram, MergesMoreShardsThanAProcessMayHaveFilesOpen) {
  const TemporaryDirectory files;
  constexpr int kShards = 60, kRuns = 90;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: " + std::to_string(kRuns) +
                                      "\nvary: {bodies.ball.mass: {uniform: [1, 2]}}");
  const std::string out = files.path("out");
  ASSERT_EQ(test::sweep(scene + " " + study + " --out " + out, "PATH=/nonexistent").exit_code, 0);
  // what the shards write are its rows
  ASSERT_EQ(test::runCommand("mkdir " + files.path("shards")).exit_code, 0);
  const auto info = tableInfoIn(test::fileText(out + "/runs.info"));
  ASSERT_TRUE(info);
  std::vector<SweepLedger> ledgers(kShards);
  for (const char* stem : {"runs", "fan"}) {
    std::ifstream in(out + "/" + stem + ".csv");
    std::string line, header;
    std::getline(in, header);
    std::vector<std::string> tables(kShards, header + "\n");
    const bool is_fan = std::string(stem) == "fan";
    for (std::size_t run = 0; std::getline(in, line); ++run) {
      SweepLedger& ledger = ledgers[run % kShards];
      tables[run % kShards] += line + "\n";
      ledger.rows += is_fan ? 0 : 1;
      (is_fan ? ledger.fan_digest : ledger.digest) += digestOfRow(line);
    }
    for (int i = 0; i < kShards; ++i) {
      const std::string name = std::to_string(i + 1) + "of" + std::to_string(kShards);
      files.written("shards/" + std::string(stem) + "." + name + ".csv",
                    tables[static_cast<std::size_t>(i)]);
      files.written("shards/runs." + name + ".info",
                    toText(TableInfo{info->sweep, ledgers[static_cast<std::size_t>(i)]}));
    }
  }
  const test::Outcome merged =
      test::runCommand("bash -c 'ulimit -n 30; PATH=/nonexistent " RIGID_BODY_SIM_SWEEP " merge " +
                       files.path("shards") + " 2>&1'");
  EXPECT_EQ(merged.exit_code, 0) << merged.out;
  for (const char* name : {"runs.csv", "fan.csv", "summary.csv"})
    EXPECT_EQ(test::fileText(files.path("shards/") + name), test::fileText(out + "/" + name));
}

namespace {

/// A tetrahedron that is as long as that along x.
std::string tetrahedronObj(double length) {
  return "v 0 0 0\nv " + std::to_string(length) +
         " 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

std::string urdfOfMass(double mass) {
  return "<robot name='r'><link name='l'><inertial><mass value='" + std::to_string(mass) +
         "'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>"
         "<visual><geometry><mesh filename='drawn.obj'/></geometry></visual>"
         "<collision><geometry><mesh "
         "filename='touches.obj'/></geometry></collision></link></robot>";
}

const std::string kBodiesOfFiles = R"(gravity: [0, 0, -10]
time_step: 0.01
horizon: 0.02
bodies:
  - {name: solid, shape: {mesh: {file: solid.obj}}, mass: 1, position: [0, 0, 9]}
  - {name: link, urdf: {file: link.urdf}, position: [9, 0, 9],
     twist: {frame: world, linear: [0, 0, 0]}}
  - {name: ground, shape: {plane: {}}, fixed: true}
forces: [{type: contact, between: [link, ground], stiffness: 1e5}]
)";

}  // namespace

// What a scene reads decides its motion as its text does; what is only drawn does not.
TEST(SweepProgram, TellsSweepsOfOtherFilesApart) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", kBodiesOfFiles);
  const std::string study = files.written("study.yaml",
                                          "runs: 4\nvary:\n"
                                          "  bodies.solid.shape.mesh.file: {list: [solid.obj, "
                                          "other.obj]}\n"
                                          "  bodies.link.twist.linear[0]: {uniform: [0, 1]}\n");
  const auto write = [&](const std::string& name, double size) {
    files.written(name, name == "link.urdf" ? urdfOfMass(size) : tetrahedronObj(size));
  };
  const std::vector<std::string> names = {"solid.obj", "other.obj", "link.urdf", "touches.obj",
                                          "drawn.obj"};
  for (const std::string& name : names) write(name, name == "other.obj" ? 3 : 1);
  const std::string command = scene + " " + study + " --out ", no_plot = "PATH=/nonexistent";
  const std::string out = files.path("out"), shards = files.path("shards");
  const test::Outcome whole = test::sweep(command + out, no_plot);
  ASSERT_EQ(whole.exit_code, 0) << whole.out;
  ASSERT_EQ(test::sweep(command + shards + " --shard 1/2", no_plot).exit_code, 0);
  const std::string rows = test::fileText(out + "/runs.csv");
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    write(name, 2);
    const int expected = name == "drawn.obj" ? 0 : 1;
    const test::Outcome resumed = test::sweep(command + out + " --resume", no_plot);
    EXPECT_EQ(resumed.exit_code, expected) << resumed.out;
    EXPECT_EQ(resumed.out.find("a file that the scene names is another") != std::string::npos,
              expected == 1)
        << resumed.out;
    EXPECT_EQ(test::fileText(out + "/runs.csv"), rows);
    ASSERT_EQ(test::sweep(command + shards + " --shard 2/2", no_plot).exit_code, 0);
    const test::Outcome merged = test::sweep("merge " + shards, no_plot);
    EXPECT_EQ(merged.exit_code, expected) << merged.out;
    write(name, name == "other.obj" ? 3 : 1);
  }
}

// Shards may be made on hosts that have the files in other directories.
TEST(SweepProgram, TellsNoSweepsApartByWhereTheirFilesAre) {
  std::vector<std::string> infos;
  for (const char* directory : {"z", "a"}) {
    const TemporaryDirectory files;
    const std::string in = files.path(directory);
    ASSERT_EQ(test::runCommand("mkdir -p " + in).exit_code, 0);
    const std::string scene = files.written(std::string(directory) + "/scene.yaml", kBodiesOfFiles);
    files.written(std::string(directory) + "/solid.obj", tetrahedronObj(1));
    files.written(std::string(directory) + "/touches.obj", tetrahedronObj(2));
    files.written(std::string(directory) + "/link.urdf", urdfOfMass(1));
    const std::string study = files.written(
        "study.yaml", "runs: 1\nvary: {'bodies.link.twist.linear[0]': {uniform: [0, 1]}}");
    const test::Outcome run =
        test::sweep(scene + " " + study + " --out " + in, "PATH=/nonexistent");
    EXPECT_EQ(run.exit_code, 0) << run.out;
    infos.push_back(test::fileText(in + "/runs.info"));
  }
  EXPECT_NE(infos[0], "");
  EXPECT_EQ(infos[0], infos[1]);
}

}  // namespace rigid_body_sim
