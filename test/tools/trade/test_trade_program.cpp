#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "math/shortest.hpp"
#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"
#include "tools/trade/trade_write.hpp"

namespace rigid_body_sim {
namespace {

const std::string kProgram = RIGID_BODY_SIM_TRADE;
const std::string kScene = std::string(RIGID_BODY_SIM_SCENES) + "/boxes_simple.yaml";
const std::string kHeader =
    "integrator,time_step,attitude_error,position_error,energy_error,angular_momentum_error,"
    "cpu_ns_per_sim_s,force_evaluations";

using test::Outcome;

/// Runs `trade` with the arguments, one string as a shell takes it.
Outcome trade(const std::string& arguments, const std::string& environment = "") {
  return test::runCommand(environment + " " + kProgram + " " + arguments);
}

std::vector<std::string> linesOf(std::istream&& text) {
  std::vector<std::string> all;
  for (std::string line; std::getline(text, line);) all.push_back(line);
  return all;
}

std::vector<std::string> fileLines(const std::string& path) { return linesOf(std::ifstream(path)); }

std::string fileText(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The two lines of advice, "integrator: …" and "time_step: …".
std::string advice(const std::string& out) {
  const std::size_t begin = out.find("\nintegrator: ") + 1;
  return out.substr(begin, out.find('\n', out.find("\ntime_step: ") + 1) + 1 - begin);
}

/// Two bodies on a spring, with comments, and the keys of the solver as given.
std::string springScene(const std::string& solver) {
  return "# a pair  # of bodies\n" + solver + R"(horizon: 1
bodies:
  - {name: a, shape: {box: [0.4, 0.3, 0.2]}, mass: 2, position: [0, 0, 0.8]}
  - {name: b, shape: {box: [0.1, 0.3, 0.2]}, mass: 1, position: [0, 0, -0.8]}  # below
forces:
  - {type: spring, from: {body: a}, to: {body: b, point: [0, 0.1, 0]}, stiffness: 12,
     damping: 1}
)";
}

/// Waits for one more byte; false where none comes any more.
bool readByte(int pipe, std::string& all) {
  constexpr int kNever = 60000;  // [ms]
  pollfd ready{pipe, POLLIN, 0};
  char byte = 0;
  if (poll(&ready, 1, kNever) != 1 || read(pipe, &byte, 1) != 1) return false;
  all += byte;
  return true;
}

/// The name, then seven numbers, none of them negative.
void expectRow(const std::string& row) {
  std::istringstream stream(row);
  std::string field;
  ASSERT_TRUE(std::getline(stream, field, ',')) << row;
  int numbers = 0;
  for (; std::getline(stream, field, ','); ++numbers) {
    char* end = nullptr;
    EXPECT_GE(std::strtod(field.c_str(), &end), 0) << row;
    EXPECT_EQ(*end, '\0') << row;
  }
  EXPECT_EQ(numbers, 7) << row;
}

}  // namespace

TEST(TradeProgram, WritesEveryRowAndTheCheapestSetting) {
  const TemporaryDirectory files;
  // names that neither the shell nor gnuplot must take for more than that
  const std::string out = files.path("here `touch ran` \"$HOME\"");
  const Outcome run = trade(kScene + " --duration 0.1 --error-budget 1e-6 --out '" + out + "'");
  EXPECT_EQ(run.exit_code, 0);
  const std::vector<std::string> rows = fileLines(out + "/trade.csv");
  ASSERT_GT(rows.size(), 9U);
  EXPECT_EQ(rows[0], kHeader);
  for (std::size_t i = 1; i < rows.size(); ++i) expectRow(rows[i]);
  for (const char* name :
       {"semi_implicit_euler", "strang", "magnus4", "rk4", "kahan_li8", "dop853", "taylor", "auto"})
    EXPECT_NE(run.out.find(name), std::string::npos) << name;
  EXPECT_NE(run.out.find("\nintegrator: "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\ntime_step: "), std::string::npos) << run.out;
  const std::vector<std::string> plot = fileLines(out + "/trade.svg");
  EXPECT_NE(std::find(plot.begin(), plot.end(), "</svg>"), plot.end());
  EXPECT_FALSE(std::ifstream("ran").good());
}

TEST(TradeProgram, SaysThatThePlotIsMissingWithoutGnuplot) {
  const TemporaryDirectory files;
  const std::string out = files.path("out");
  const Outcome run = trade(kScene + " --duration 0.1 --out " + out, "PATH=/nonexistent");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("gnuplot is not installed"), std::string::npos) << run.out;
  EXPECT_GT(fileLines(out + "/trade.csv").size(), 9U);
}

TEST(TradeProgram, KeepsTheStepOfASceneThatIsSolvedWhateverTheStep) {
  const TemporaryDirectory files;
  const Outcome run = trade(kScene + " --duration 0.1 --out " + files.path("out"));
  EXPECT_NE(run.out.find("That is what the scene says now.\n"), std::string::npos) << run.out;
}

TEST(TradeProgram, WritesItsAdviceIntoTheSceneAndKeepsTheRest) {
  const TemporaryDirectory files;
  const std::string path =
      files.written("scene.yaml", springScene("time_step: 5e-11   # [s]\ntolerance: 1e-3\n"));
  // too short for errors above rounding: every ladder has a few steps
  const Outcome run = trade(path + " --duration 1e-9 --write --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0);
  const Scene written = loadScene(path);
  EXPECT_EQ(advice(run.out), "integrator: " + written.integrator +
                                 "\ntime_step: " + shortest(written.time_step) + "\n");
  EXPECT_GT(written.time_step, 5e-11);
  EXPECT_EQ(fileText(path),
            springScene("time_step: " + shortest(written.time_step) +
                        "   # [s]\nintegrator: " + written.integrator + "\n# tolerance: 1e-3\n"));
}

TEST(WriteSolver, ReplacesTwoKeysAndKeepsEverythingElse) {
  const TemporaryDirectory files;
  const std::string path =
      files.written("scene.yaml", springScene("time_step: 0.001   # [s]\ntolerance: 1e-3\n"));
  EXPECT_EQ(writeSolver(path, "rk4", 0.03), path + ": now integrator rk4, time_step 0.03");
  EXPECT_EQ(fileText(path), springScene("time_step: 0.03   # [s]\nintegrator: rk4\n# tolerance: "
                                        "1e-3\n"));
  writeSolver(path, "auto", 0.1);
  EXPECT_EQ(fileText(path),
            springScene("time_step: 0.1   # [s]\nintegrator: auto\n# tolerance: 1e-3\n"));
  // ends of lines as they are
  std::string windows;
  for (char c : springScene("time_step: 0.001\n"))
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::ofstream(path, std::ios::binary) << windows;
  writeSolver(path, "dop853", 0.25);
  windows.replace(windows.find("0.001"), 5, "0.25\r\nintegrator: dop853");
  EXPECT_EQ(fileText(path), windows);
}

TEST(TradeProgram, LeavesASceneThatItCannotEditAsItIs) {
  const TemporaryDirectory files;
  const std::string flow =
      "{time_step: 5e-11, tolerance: 1e-3, bodies: [{name: a, mass: 1, shape: {box: "
      "[1, 2, 3]}}], forces: [{type: spring, from: {body: a}, to: {world: [0, 0, 1]}, stiffness: "
      "9, damping: 1}]}\n";
  const std::string path = files.written("scene.yaml", flow);
  const Outcome run = trade(path + " --duration 1e-9 --write --out " + files.path("out") + " 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.out.find("scene.yaml: its keys do not stand on lines of their own: left as it was"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(fileText(path), flow);
}

TEST(TradeProgram, MeasuresARunShorterThanAStep) {
  const TemporaryDirectory files;
  const std::string out = files.path("out");
  const Outcome run = trade(kScene + " --duration 1e-9 --out " + out + " 2>&1");
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("inf"), std::string::npos) << run.out;
  const std::vector<std::string> rows = fileLines(out + "/trade.csv");
  ASSERT_GT(rows.size(), 2U);
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].find("inf"), std::string::npos) << rows[i];
}

TEST(TradeProgram, RefusesToOverwriteTheSceneByItsTable) {
  const TemporaryDirectory files;
  const std::string path = files.written("trade.csv", springScene("time_step: 0.005\n"));
  const Outcome run = trade(path + " --out " + files.path("") + " 2>&1");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.out.find("the table and the scene are the same file"), std::string::npos)
      << run.out;
  EXPECT_EQ(fileText(path), springScene("time_step: 0.005\n"));
}

TEST(TradeProgram, RefusesToOverwriteAFileThatTheSceneNames) {
  const TemporaryDirectory files;
  const std::string robot =
      "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
      "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>";
  const std::string urdf = files.written("trade.csv", robot);
  const std::string path = files.written(
      "scene.yaml", "time_step: 0.01\nbodies: [{name: a, urdf: {file: trade.csv}}]\n");
  const Outcome run = trade(path + " --duration 0.1 --out " + files.path("") + " 2>&1");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.out.find("the table and a file that the scene names are the same file"),
            std::string::npos)
      << run.out;
  EXPECT_EQ(fileText(urdf), robot);
}

TEST(TradeProgram, LeavesAValidFileWhenInterrupted) {
  const TemporaryDirectory files;
  // a pipe in place of the file: whoever reads is woken, and what no one reads holds the writer up
  const std::string table = files.path("trade.csv");
  ASSERT_EQ(mkfifo(table.c_str(), 0600), 0);
  const int csv = open(table.c_str(), O_RDONLY | O_NONBLOCK);
  // the least there is; the whole table takes 9 kB
  ASSERT_EQ(fcntl(csv, F_SETPIPE_SZ, 4096), 4096);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL);  // ignored in what a script runs in the background
    close(STDERR_FILENO);
    execl(kProgram.c_str(), "trade", kScene.c_str(), "--out", files.path("").c_str(), nullptr);
    _exit(127);
  }
  ASSERT_GT(child, 0);
  std::string written;
  while (std::count(written.begin(), written.end(), '\n') < 4 && readByte(csv, written)) {
  }
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  while (readByte(csv, written)) {
  }
  close(csv);
  EXPECT_TRUE(WIFSIGNALED(status));
  ASSERT_FALSE(written.empty());
  EXPECT_EQ(written.back(), '\n');
  const std::vector<std::string> rows = linesOf(std::istringstream(written));
  ASSERT_GE(rows.size(), 4U);
  EXPECT_EQ(rows[0], kHeader);
  for (std::size_t i = 1; i < rows.size(); ++i) expectRow(rows[i]);
}

TEST(TradeProgram, ExitsWithOneForBadInput) {
  const Outcome absent = trade("absent.yaml 2>&1");
  EXPECT_EQ(absent.exit_code, 1);
  EXPECT_NE(absent.out.find("absent.yaml"), std::string::npos);
  EXPECT_EQ(trade(kScene + " --out /dev/null/here 2>&1").exit_code, 1);
}

TEST(TradeProgram, ExitsWithTwoForWrongUsage) {
  for (const char* arguments : {"", "a.yaml b.yaml", "a.yaml --no-such-option", "a.yaml --out",
                                "a.yaml --duration 1x", "a.yaml --error-budget 0"})
    EXPECT_EQ(trade(std::string(arguments) + " 2>&1").exit_code, 2) << arguments;
  const TemporaryDirectory files;
  const Outcome endless = trade(kScene + " --duration 1e300 --out " + files.path("out") + " 2>&1");
  EXPECT_EQ(endless.exit_code, 2);
  EXPECT_NE(endless.out.find("must be at most 2^53 steps"), std::string::npos) << endless.out;
}

TEST(TradeProgram, ExitsWithThreeWhenTheReferenceDiverges) {
  const TemporaryDirectory files;
  const std::string path = files.written("scene.yaml", R"(
time_step: 1.0
bodies: [{name: rocket, shape: {sphere: {radius: 1}}, mass: 1.0e-300}]
wrenches: [{body: rocket, frame: world, force: [1.0e+300, 0, 0], duration: 1000}]
)");
  const Outcome run = trade(path + " --out " + files.path("out") + " 2>&1");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.out.find("body 'rocket'"), std::string::npos) << run.out;
}

TEST(TradeProgram, HelpsOnRequest) {
  const Outcome run = trade("--help");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.out.find("usage: trade SCENE"), std::string::npos);
}

}  // namespace rigid_body_sim
