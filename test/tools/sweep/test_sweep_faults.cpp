#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "tools/sweep/sweep_bench.hpp"

/// Studies and command lines that are refused.
namespace rigid_body_sim {

using test::sweep;

TEST(SweepProgram, SaysInOneLineWhatIsAtFault) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const auto fault = [&](const std::string& study, const std::string& options = "") {
    const test::Outcome run = sweep(scene + " " + files.written("bad.yaml", study) + " --out " +
                                    files.path("out") + " " + options);
    EXPECT_EQ(run.exit_code, 1) << run.out;
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), 1) << run.out;
    return run.out.substr(0, run.out.size() - 1);
  };
  const std::string bad = "sweep: " + files.path("bad.yaml");
  EXPECT_EQ(fault("runs: 2\nvary: {bodies.ball.mass: {list: [1, heavy]}}"),
            bad + ":2: vary: 'bodies.ball.mass' cannot be heavy: " + scene +
                ":5: body 'ball': mass must be a number [kg], got heavy");
  EXPECT_EQ(fault("runs: 2\nvary: {bodies.ball.mass: {normal: {mean: -5, stddev: 1}}}"),
            bad + ":2: vary: 'bodies.ball.mass' cannot be -5: " + scene +
                ":5: body 'ball': mass must be > 0 kg, got -5");
  EXPECT_EQ(fault("runs: 2\nvary: {bodies.bell.mass: {list: [1, 2]}}"),
            bad + ":2: vary: 'bodies.bell.mass' is not in " + scene +
                "; the nearest that is: 'bodies.ball.mass'; a key that the scene leaves out must "
                "be written into it first");
  EXPECT_EQ(fault("runs: 2\nvary: {bodies.ball.mass: {list: ['']}}"),
            bad + ":2: vary: 'bodies.ball.mass' cannot be \"\": " + scene +
                ":5: body 'ball': mass must be a number [kg], got \"\"");
  EXPECT_EQ(fault("runs: 2\nvary: {integrator: {list: [auto, rk4]}, tolerance: {list: [1e-3]}}"),
            bad + ":2: vary: 'integrator' cannot be rk4: " + scene +
                ":1: tolerance goes with integrator auto only, got integrator rk4; the study "
                "varies 'tolerance', too, and so states it");
  EXPECT_EQ(fault("runs: 2\nvary: {bodies.ball.mass: {list: [1, 2]}}\nrecord: {a: {max: bell.pz}}"),
            bad + ":3: record.a: unknown body 'bell' (known: ball); did you mean 'ball'?");
  EXPECT_EQ(fault("runs: 2\nvary: {integrator: {grid: [auto, rk5]}}")
                .find(bad + ":2: vary: 'integrator' cannot be rk5: "),
            0U);
  files.written("file", "");
  const std::string good = "runs: 2\nvary: {bodies.ball.mass: {list: [1, 2]}}";
  const test::Outcome no_directory =
      sweep(scene + " " + files.written("good.yaml", good) + " --out " + files.path("file"));
  EXPECT_EQ(no_directory.exit_code, 1);
  EXPECT_EQ(no_directory.out,
            "sweep: " + files.path("file") + ": is a file, and must be a directory\n");
  // a value that is reached after many others
  std::string values;
  for (int i = 1; i <= 1500; ++i) values += std::to_string(i) + ", ";
  EXPECT_NE(fault("runs: 2\nvary: {bodies.ball.mass: {list: [" + values + "-1]}}")
                .find("'bodies.ball.mass' cannot be -1: "),
            std::string::npos);
}

TEST(SweepProgram, RecordsAndVariesNothingOfABodyThatIsAbsent) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(
time_step: 0.01
horizon: 0.1
bodies:
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1, position: [0, 0, 0]}
  - {name: guest, shape: {sphere: {radius: 1}}, mass: 1, absent: true,
     twist: {frame: world, linear: [1, 0, 0]}}
)");
  const auto swept = [&](const std::string& study) {
    return sweep(scene + " " + files.written("study.yaml", study) + " --out " + files.path("out"));
  };
  const std::string at = "sweep: " + files.path("study.yaml");
  const std::string vary = "runs: 2\nvary:\n  bodies.ball.position[0]: {list: [1, 2]}\n";
  EXPECT_EQ(swept(vary + "record: {a: {max: guest.pz}}").out,
            at + ":4: record.a: body 'guest' is absent in the scene, and nothing brings it in "
                 "during a sweep; remove 'absent: true' there, or record another body\n");
  EXPECT_EQ(swept("runs: 2\nvary: {bodies.guest.mass: {list: [1, 2]}}").out,
            at + ":2: vary: 'bodies.guest.mass' varies nothing: the bodies move alike whether it "
                 "is 1 or not; remove it, or change in the scene what keeps it from acting\n");
  EXPECT_EQ(swept(vary).exit_code, 0);
  std::ifstream rows(files.path("out/runs.csv"));
  std::string header;
  std::getline(rows, header);
  EXPECT_NE(header.find("ball.pz"), std::string::npos) << header;
  EXPECT_EQ(header.find("guest"), std::string::npos) << header;
}

TEST(SweepProgram, MakesRowsOfDrawsThatBreakARuleWhateverTheMean) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  for (const char* mass : {"normal: {mean: 0, stddev: 1}", "uniform: [-1, 1]"}) {
    const std::string study = files.written(
        "study.yaml", "runs: 40\nvary: {bodies.ball.mass: {" + std::string(mass) + "}}");
    const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
    ASSERT_EQ(run.exit_code, 0) << run.out;
    const auto statuses = test::tableAt(files.path("out/runs.csv")).at("status");
    const auto done = std::count(statuses.begin(), statuses.end(), "done");
    EXPECT_EQ(statuses.size(), 40U);
    EXPECT_GT(done, 5);
    EXPECT_LT(done, 35);
  }
}

// What is tried before the runs is no reason to make none.
TEST(SweepProgram, GoesOnWhereATriedValueDiverges) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.5
horizon: 1
bodies: [{name: rocket, shape: {sphere: {radius: 1}}, mass: 1.0e-300, visual: {color: [1, 0, 0, 1]}}]
wrenches: [{body: rocket, frame: world, force: [1.0e300, 0, 0], start: 0, duration: 1000}]
)");
  const std::string study = files.written(
      "study.yaml", "runs: 2\nvary: {'bodies.rocket.visual.color[0]': {list: [0.1, 1]}}");
  const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0) << run.out;
  const auto table = test::tableAt(files.path("out/runs.csv"));
  for (const std::string& status : table.at("status"))
    EXPECT_EQ(status.rfind("diverged: ", 0), 0U) << status;
}

TEST(SweepProgram, VariesATimeStepOnlyWhereItIsTaken) {
  const TemporaryDirectory files;
  const auto run = [&](const std::string& scene, const std::string& more) {
    return sweep(
        files.written("scene.yaml", scene) + " " +
        files.written("study.yaml", "runs: 1\nvary:\n  time_step: {grid: [0.01, 0.02]}\n" + more) +
        " --out " + files.path("out"));
  };
  EXPECT_NE(run(test::kPushedBall, "").out.find("'time_step' varies nothing"), std::string::npos);
  // extremes are looked for at time steps
  EXPECT_EQ(run(test::kPushedBall, "record: {apex: {max: ball.pz}}").exit_code, 0);
  EXPECT_EQ(run("integrator: rk4\n" + test::kPushedBall, "").exit_code, 0);
  // of the integrators that vary one goes by it
  EXPECT_EQ(run(test::kPushedBall, "  integrator: {grid: [auto, rk4]}\n").exit_code, 0);
}

// It says how long a run is unless the study does.
TEST(SweepProgram, VariesAHorizonOnlyWhereItIsTaken) {
  const TemporaryDirectory files;
  const auto run = [&](const std::string& scene, const std::string& more) {
    return sweep(files.written("scene.yaml", scene) + " " +
                 files.written("study.yaml", more + "runs: 1\nvary: {horizon: {grid: [1, 2]}}\n") +
                 " --out " + files.path("out"));
  };
  EXPECT_EQ(run(test::kPushedBall, "").exit_code, 0);
  EXPECT_NE(run(test::kPushedBall, "duration: 1\n").out.find("'horizon' varies nothing"),
            std::string::npos);
  // the tolerance is held over it
  const std::string spun = "tolerance: 1e-3\n" + test::kPushedBall +
                           "  - {body: ball, frame: ball, point: [0.1, 0, 0.05], force: [0, 1, 0], "
                           "start: 0.1, duration: 2}\n";
  EXPECT_EQ(run(spun, "duration: 1\n").exit_code, 0);
}

TEST(SweepProgram, RefusesAPathThatVariesNothing) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.5
bodies:
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1, visual: {color: [1, 0, 0, 1]}}
  - {name: rock, shape: {sphere: {radius: 1}}, mass: 1, fixed: true, position: [5, 0, 0]}
)");
  for (const char* path : {"bodies.ball.visual.color[1]", "bodies.rock.mass"}) {
    const std::string study = files.written(
        "study.yaml", "runs: 2\nvary: {'" + std::string(path) + "': {uniform: [0.1, 0.9]}}");
    const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out.find("sweep: " + study + ":2: vary: '" + path + "' varies nothing"), 0U)
        << run.out;
  }
}

// The frame of a twist counts once the body is turned, which here varies, too.
TEST(SweepProgram, VariesWhatCountsBesideOtherPathsAlone) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const auto run = [&](const std::string& more) {
    return sweep(scene + " " +
                     files.written("study.yaml",
                                   "runs: 4\nvary:\n  bodies.ball.twist.frame: {list: "
                                   "[world, body]}\n" +
                                       more) +
                     " --out " + files.path("out"),
                 "PATH=/nonexistent");
  };
  EXPECT_EQ(run("  bodies.ball.orientation: {rotation: {}}\n").exit_code, 0);
  EXPECT_EQ(test::tableAt(files.path("out/runs.csv")).at("status").size(), 4U);
  for (const char* more : {"", "  bodies.ball.mass: {uniform: [1, 2]}\n"})
    EXPECT_NE(run(more).out.find(":3: vary: 'bodies.ball.twist.frame' varies nothing"),
              std::string::npos);
}

TEST(SweepProgram, LeavesATableAloneThatAnotherSweepIsWriting) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 3\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string command = scene + " " + study + " --out " + files.path("out");
  ASSERT_EQ(sweep(command).exit_code, 0);
  const std::string rows = test::fileText(files.path("out/runs.csv"));
  const std::string info = test::fileText(files.path("out/runs.info"));
  const int other = open(files.path("out/runs.csv").c_str(), O_WRONLY | O_APPEND);
  ASSERT_EQ(flock(other, LOCK_EX), 0);
  for (const char* options : {" --seed 4", " --resume"}) {
    const test::Outcome run = sweep(command + options);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "sweep: " + files.path("out/runs.csv") +
                           ": another sweep is writing it; wait for it, or name another --out\n");
  }
  EXPECT_EQ(test::fileText(files.path("out/runs.csv")), rows);
  EXPECT_EQ(test::fileText(files.path("out/runs.info")), info);
  close(other);
  EXPECT_EQ(sweep(command + " --seed 4").exit_code, 0);
}

// Neither is there a row to lose, nor do old ones say of what sweep they are.
TEST(SweepProgram, ResumesWhereATableHasNoRows) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", test::kPushedBall);
  const std::string study =
      files.written("study.yaml", "runs: 3\nvary: {bodies.ball.mass: {list: [1, 2]}}");
  const std::string command = scene + " " + study + " --resume --out " + files.path("out");
  ASSERT_EQ(sweep(command).exit_code, 0);
  const std::string rows = test::fileText(files.path("out/runs.csv"));
  files.written("out/runs.csv", rows.substr(0, rows.find('\n') + 1));
  ASSERT_EQ(remove(files.path("out/runs.info").c_str()), 0);
  ASSERT_EQ(sweep(command).exit_code, 0);
  EXPECT_EQ(test::fileText(files.path("out/runs.csv")), rows);
}

TEST(SweepProgram, DrawsAQuantityThatNeverChangesWithoutAWarning) {
  const TemporaryDirectory files;
  const std::string scene = files.written("scene.yaml", R"(time_step: 0.5
horizon: 1
bodies: [{name: ball, shape: {sphere: {radius: 1}}, mass: 1, twist: {frame: world, linear: [1, 0, 0]}}]
)");
  const std::string study = files.written(
      "study.yaml", "runs: 3\nvary: {'bodies.ball.twist.linear[0]': {uniform: [1, 2]}}");
  const test::Outcome run = sweep(scene + " " + study + " --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("arning"), std::string::npos) << run.out;
}

TEST(SweepProgram, ExitsWithTwoForWrongUsage) {
  for (const char* arguments :
       {"", "a.yaml", "a.yaml b.yaml c.yaml", "a.yaml b.yaml --runs -5", "a.yaml b.yaml --runs 1e3",
        "a.yaml b.yaml --threads 0", "a.yaml b.yaml --shard 3/2", "a.yaml b.yaml --shard 0/2",
        "a.yaml b.yaml --seed x", "a.yaml b.yaml --out \'\'", "merge"})
    EXPECT_EQ(sweep(arguments).exit_code, 2) << arguments;
  EXPECT_EQ(sweep("a.yaml b.yaml", "SLURM_ARRAY_TASK_ID=3").exit_code, 2);
  EXPECT_EQ(sweep("a.yaml b.yaml --out \'\'").out,
            "sweep: --out: must not be empty (sweep --help)\n");
  EXPECT_EQ(sweep("merge \'\'").out,
            "sweep: an argument is empty: it must be a path (sweep --help)\n");
}

}  // namespace rigid_body_sim
