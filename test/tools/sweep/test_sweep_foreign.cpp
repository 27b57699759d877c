#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tools/sweep/sweep_bench.hpp"
#include "tools/sweep/table_lines.hpp"

/// What is no file of a sweep where a sweep would write one, or read one.
namespace rigid_body_sim {
namespace {

struct ForeignBench : test::SweepFiles {
  ForeignBench()
      : SweepFiles(test::kPushedBall, "runs: 6\nvary: {bodies.ball.mass: {list: [1, 2]}}") {}

  /// Which would wait for ever where it reads a pipe.
  test::Outcome sweep(const std::string& arguments) const {
    return test::sweep(arguments, "PATH=/usr/bin:/bin timeout 20 env PATH=/nonexistent");
  }
  test::Outcome into(const std::string& directory, const std::string& options = "") const {
    return sweep(scene + " " + study + " --out " + files.path(directory) + " " + options);
  }
  std::string emptyDirectory(const std::string& name) const {
    std::filesystem::remove_all(files.path(name));
    std::filesystem::create_directory(files.path(name));
    return files.path(name);
  }
};

}  // namespace

TEST(SweepProgram, ReplacesNoFileOfItsUser) {
  const ForeignBench bench;
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(bench.into("shards", std::string("--shard ") + shard).exit_code, 0);
  const std::string merge = "merge " + bench.files.path("shards") + " --out ";
  for (const char* name : {"summary.csv", "sweep.svg", "runs.info"}) {
    const std::string out = bench.emptyDirectory("out"), mine = out + "/" + name;
    bench.files.written(std::string("out/") + name, "mine\n");
    const std::string refusal =
        "sweep: " + mine +
        ": is not of a sweep, and would be replaced; remove it, or name another --out\n";
    EXPECT_EQ(bench.into("out").out, refusal);
    EXPECT_EQ(bench.into("out", "--resume").out, refusal);
    EXPECT_EQ(bench.sweep(merge + out).out, refusal);
    EXPECT_EQ(test::fileText(mine), "mine\n");
    EXPECT_FALSE(std::filesystem::exists(out + "/runs.csv"));
    // of a shard it is none of its files
    EXPECT_EQ(bench.into("out", "--shard 1/2").exit_code, 0);
    EXPECT_EQ(test::fileText(mine), "mine\n");
  }
  const std::string out = bench.emptyDirectory("out");
  bench.files.written("out/runs.csv.part", "mine\n");
  EXPECT_EQ(bench.sweep(merge + out).exit_code, 1);
  EXPECT_EQ(test::fileText(out + "/runs.csv.part"), "mine\n");
  bench.files.written("out/run_2.yaml", "mine\n");
  EXPECT_EQ(bench.into("out", "--run 2").exit_code, 1);
  EXPECT_EQ(test::fileText(out + "/run_2.yaml"), "mine\n");
}

// Its own it knows, also where a full disk has cut them.
TEST(SweepProgram, ReplacesItsOwnFiles) {
  const ForeignBench bench;
  const auto swept = [&](const std::string& options) {
    return test::sweep(bench.scene + " " + bench.study + " --out " + bench.files.path("out") + " " +
                       options);
  };
  for (const char* options : {"", "", "--resume", "--run 2", "--run 2"})
    EXPECT_EQ(swept(options).exit_code, 0) << options;
  for (const char* name : {"out/summary.csv", "out/runs.csv"})
    for (const std::size_t kept : {std::size_t{3}, std::size_t{0}}) {
      const std::string text = test::fileText(bench.files.path(name));
      bench.files.written(name, text.substr(0, kept));
      EXPECT_EQ(swept("").exit_code, 0) << name;
    }
}

TEST(SweepProgram, NeitherWaitsForAPipeNorReadsADevice) {
  const ForeignBench bench;
  for (const char* name : {"runs.csv", "fan.csv", "runs.info", "summary.csv", "sweep.svg"})
    for (const char* make : {"mkfifo ", "ln -s /dev/full "}) {
      const std::string path = bench.emptyDirectory("out") + "/" + name;
      ASSERT_EQ(test::runCommand(make + path).exit_code, 0);
      const test::Outcome run = bench.into("out");
      EXPECT_EQ(run.exit_code, 1);
      EXPECT_EQ(run.out, "sweep: " + path + ": is no regular file\n") << make;
    }
  // nor does it follow a link to itself until all runs are made
  for (const char* name : {"runs.csv", "fan.csv", "runs.info", "summary.csv", "sweep.svg"}) {
    const std::string path = bench.emptyDirectory("out") + "/" + name;
    std::filesystem::create_symlink(name, path);
    EXPECT_EQ(bench.into("out").out,
              "sweep: " + path +
                  ": cannot be read: Too many levels of symbolic links; remove it, or name another "
                  "--out\n");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(bench.files.path("out")), {}), 1);
  }
  std::filesystem::create_symlink("nowhere", bench.files.path("link"));
  EXPECT_EQ(bench.into("link").out,
            "sweep: " + bench.files.path("link") + ": is a link that leads to no directory\n");
  // nor what is merged
  bench.emptyDirectory("out");
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(bench.into("out", std::string("--shard ") + shard).exit_code, 0);
  for (const char* name : {"runs.1of2.csv", "fan.1of2.csv", "runs.1of2.info"}) {
    const std::string path = bench.files.path("out/") + name, kept = bench.files.path("kept");
    ASSERT_EQ(test::runCommand("mv " + path + " " + kept + " && mkfifo " + path).exit_code, 0);
    EXPECT_EQ(bench.sweep("merge " + bench.files.path("out")).out,
              "sweep: " + path + ": is no regular file\n");
    ASSERT_EQ(test::runCommand("mv " + kept + " " + path).exit_code, 0);
  }
}

// Whatever is in a file, and wherever a piece of it ends.
TEST(TableLines, CutsWhatIsNoLineOfATable) {
  const TemporaryDirectory files;
  const std::string path = files.written("table", "ab\n\nabcde\n" + std::string(50, 'x') + "\ny");
  for (const std::size_t piece : {1U, 2U, 3U, 7U, 100U}) {
    TableLines lines(path, piece);
    std::string line;
    for (const char* whole : {"ab", "", "abcde"}) {
      ASSERT_TRUE(lines.next(line, 5));
      EXPECT_EQ(line, whole);
    }
    EXPECT_EQ(lines.bytes(), 10);
    ASSERT_TRUE(lines.next(line, 40));
    EXPECT_EQ(line, std::string(41, 'x'));
    ASSERT_TRUE(lines.next(line, 40));
    EXPECT_EQ(line, std::string(9, 'x'));
    EXPECT_EQ(lines.bytes(), 61);
    EXPECT_FALSE(lines.next(line, 40)) << "what has no end";
    EXPECT_EQ(lines.bytes(), 61);
  }
  std::string line;
  EXPECT_FALSE(TableLines(files.path("nothing")).next(line, 5));
}

}  // namespace rigid_body_sim
